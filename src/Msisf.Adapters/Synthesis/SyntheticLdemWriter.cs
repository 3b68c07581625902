using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Writes a synthetic model of latitude and longitude, block by block, so that memory does not grow with the model.</summary>
public static class SyntheticLdemWriter
{
    /// <summary>Computes and writes a model. The same options give the same bytes.</summary>
    /// <param name="options">What and where.</param>
    /// <param name="progress">Told the fraction done, 0 to 1, from any of the threads.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <returns>Path of the label; the image lies beside it.</returns>
    /// <exception cref="UsageException">The region is none.</exception>
    /// <exception cref="BadInputException">
    /// The resolution does not fit the base, a height does not fit 16 bits, or the name is that of a file that is not synthetic.
    /// </exception>
    /// <exception cref="ExternalPartException">The disk is too full, or refuses.</exception>
    public static string Write(SyntheticLdemOptions options, IProgress<double>? progress, CancellationToken cancellation)
    {
        if (!options.Region.IsValid)
        {
            throw new UsageException($"The region {options.Region} is none: {MoonRegion.ValidValues}.");
        }

        if (options.Rest == SyntheticRest.None && options.Region.CrossesPrimeMeridian)
        {
            throw new UsageException(
                "--rest none writes a part as NASA's products have them, which don't cross the prime meridian. Give --rest base or flat.");
        }

        SyntheticTerrain terrain = new(options.PixelsPerDegree, options.Seed, options.Base, cancellation);
        SyntheticLdemProduct product = new(options.PixelsPerDegree, options.Region, options.Rest, options.Format)
        {
            Body = options.Body,
        };
        return SyntheticProductFiles.Write(
            options.OutputFolder,
            product.ProductId,
            product.Bytes,
            product.StoredBytes,
            file => new SyntheticLdemImage(terrain, product, options.Threads).Write(file, progress, cancellation),
            (writer, extremes) => SyntheticLdemLabel.Of(product, options).Write(writer, extremes.Minimum, extremes.Maximum));
    }
}
