using Msisf.Core;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Writes a synthetic polar map, block by block, so that memory does not grow with it.</summary>
public static class SyntheticMapWriter
{
    /// <summary>Degrees: the lowest absolute latitude of the middle of a map's sides; its corners then reach to 30 degrees.</summary>
    public const double LowestLatitude = 45.0;

    /// <summary>
    /// Degrees: the lowest latitude of a map that continues a base model. Its corners then reach to 75.9 degrees, where the detail's means
    /// over the base's pixels, which are those of another grid, are hardly taken off any more (docs/synthetic-ldem.md, Polar caps).
    /// </summary>
    public const double LowestLatitudeWithBase = 80.0;

    /// <summary>Computes and writes a map. The same options give the same bytes.</summary>
    /// <param name="options">What and where.</param>
    /// <param name="progress">Told the fraction done, 0 to 1, from any of the threads.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <returns>Path of the label; the image lies beside it.</returns>
    /// <exception cref="BadInputException">
    /// The map has no samples, does not fit the base, a height does not fit 16 bits, or the name is that of a file that is not synthetic.
    /// </exception>
    /// <exception cref="ExternalPartException">The disk is too full, or refuses.</exception>
    public static string Write(SyntheticMapOptions options, IProgress<double>? progress, CancellationToken cancellation)
    {
        double lowest = options.Base is null ? LowestLatitude : LowestLatitudeWithBase;
        Guard.InRange(
            options.LatitudeDegrees,
            lowest,
            90.0,
            options.Base is null ? "The latitude of a polar map (degrees)" : "The latitude of a polar map that continues a base (degrees)");
        if (options.Side < 2)
        {
            throw new BadInputException(
                $"A map from {options.LatitudeDegrees} degrees of latitude to the pole has no samples at {options.MetresPerPixel} m/px. "
                    + $"Take a lower latitude or a finer scale.");
        }

        SyntheticTerrain terrain = SyntheticTerrain.ForMap(options.MetresPerPixel, options.Seed, options.Base, cancellation);
        return SyntheticProductFiles.Write(
            options.OutputFolder,
            options.ProductId,
            options.Bytes,
            options.Bytes,
            file => new SyntheticMapImage(terrain, options).Write(file, progress, cancellation),
            (writer, extremes) => SyntheticMapLabel.Of(options).Write(writer, extremes.Minimum, extremes.Maximum));
    }
}
