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
        return SyntheticProductFiles.Write(
            options.OutputFolder,
            options.ProductId,
            options.Bytes,
            options.StoredBytes,
            file => new SyntheticLdemImage(terrain, options).Write(file, progress, cancellation),
            (writer, extremes) => SyntheticLdemLabel.Of(options).Write(writer, extremes.Minimum, extremes.Maximum));
    }
}

/// <summary>Makes the label of a synthetic product of latitude and longitude.</summary>
internal static class SyntheticLdemLabel
{
    /// <summary>Describes a product.</summary>
    /// <param name="product">What is described, and how it was made.</param>
    public static SyntheticLabel Of(SyntheticLdemOptions product)
    {
        double metresPerPixel = product.Body.MeanRadius * Math.PI / (180.0 * product.PixelsPerDegree);
        string scale = metresPerPixel.ToString("0.00", CultureInfo.InvariantCulture);
        MoonRegion region = product.Cover;
        return new SyntheticLabel
        {
            ProductId = product.ProductId,
            Body = product.Body,
            Description = DescriptionOf(product, scale),
            Lines = product.Lines,
            LineSamples = product.LineSamples,
            Format = product.Format,
            Notes = NotesOf(product.Format),
            Map = new SyntheticLabelMap
            {
                Catalogue = "DSMAP.CAT",
                Projection = "SIMPLE CYLINDRICAL",
                Resolution = product.PixelsPerDegree.ToString(CultureInfo.InvariantCulture),
                Scale = scale,
                CentreLatitude = 0,
                CentreLongitude = 180,
                North = region.NorthDegrees,
                South = region.SouthDegrees,
                West = region.WestDegrees,
                East = region.EastDegrees,

                // As in the archive: offsets count from the product's own first pixel to the projection's centre.
                LineOffset = (region.NorthDegrees * product.PixelsPerDegree) - 0.5,
                SampleOffset = ((180 - region.WestDegrees) * product.PixelsPerDegree) - 0.5,
            },
        };
    }

    private static string DescriptionOf(SyntheticLdemOptions product, string scale)
    {
        string source = product.Base is null
            ? "nothing (a made-up global shape)"
            : $"{product.Base.ProductId} ({product.Base.PixelsPerDegree.ToString(CultureInfo.InvariantCulture)} pix/deg), "
                + $"whose pixel means it keeps";
        return Invariant($"""
               A shape map (radius) of {(product.Body.IsMoon ? "a Moon" : $"a {product.Body.Name}")} at a resolution of {scale} m/pix by
               {scale} m/pix, computed from the seed
               {product.Seed}, continuing
               {source},
               downwards with random craters and roughness that follow the Moon's
               statistics{DetailIn(product)}. The map is in the form of a binary table with one row for
               each 1/{product.PixelsPerDegree} degree of latitude, pixel registered. Map values are
               relative to a radius of {product.Body.MeanRadius / 1000.0:R} km.
            """);
    }

    private static string NotesOf(SyntheticSampleFormat format) => $"""

        {Comment("NOTE:")}
        {Comment($"Conversion from Digital Number to HEIGHT, i.e. elevation in {format.UnitWord}, is:")}
        {Comment("HEIGHT = (DN * SCALING_FACTOR).")}
        {Comment($"The conversion from Digital Number to PLANETARY_RADIUS in {format.UnitWord} is:")}
        {Comment("PLANETARY_RADIUS = (DN * SCALING_FACTOR) + OFFSET")}
        {Comment("where OFFSET is the radius of a reference sphere.")}


        """;

    private static string Comment(string text)
    {
        const int Width = 72;
        return $"/* {text.PadRight(Width)}*/";
    }

    /// <summary>Continues the sentence about the detail, by where it is.</summary>
    private static string DetailIn(SyntheticLdemOptions product)
    {
        if (product.Rest == SyntheticRest.None || product.Region == MoonRegion.WholeMoon)
        {
            return string.Empty;
        }

        MoonRegion region = product.Region;
        return Invariant(
            $",\n   in latitudes {region.SouthDegrees} to {region.NorthDegrees} and longitudes {region.WestDegrees} to "
                + $"{region.EastLongitude} only; the rest\n   is {(product.Rest == SyntheticRest.Base ? "interpolated" : "flat")}");
    }
}
