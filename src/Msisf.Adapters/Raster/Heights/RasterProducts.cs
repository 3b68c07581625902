namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Products whose files do not say all that is needed to read their heights; the name says it. From the products' documents: the files
/// themselves were not at hand (docs/elevation-formats.md).
/// </summary>
internal static class RasterProducts
{
    private static readonly string[] OfMeans = ["LDEM", "SLDEM"];

    private static readonly RasterProduct[] Known =
    [
        // LROC's stereo models: 32-bit floats in m over 1737.4 km.
        new("NAC_DTM_", string.Empty, MetresPerStep: 1.0),

        // LROC's 100 m model: 16-bit integers in m over 1737.4 km.
        new("WAC_GLD100", string.Empty, MetresPerStep: 1.0),
        new("LUNAR_LRO_LROC-WAC_GLD100", string.Empty, MetresPerStep: 1.0),

        // LOLA's and Kaguya's, compressed: the integers of the .IMG in steps of 0.5 m; JPEG 2000 has no place for a factor.
        new("SLDEM2015_", ".JP2", MetresPerStep: 0.5),
        new("LDEM_", ".JP2", MetresPerStep: 0.5),
    ];

    /// <summary>Whether the samples of a product are means of cells, by its name: LOLA's, and those merged with Kaguya's, are.</summary>
    public static bool HoldsMeans(string productId) =>
        Array.Exists(OfMeans, name => productId.StartsWith(name, StringComparison.OrdinalIgnoreCase));

    /// <summary>The product of a file; null if the name is none of them.</summary>
    public static RasterProduct? Find(string path)
    {
        string name = Path.GetFileName(path);
        return Known.FirstOrDefault(product => name.StartsWith(product.Prefix, StringComparison.OrdinalIgnoreCase)
            && name.EndsWith(product.Suffix, StringComparison.OrdinalIgnoreCase));
    }
}

/// <summary>A product that is known by its name.</summary>
/// <param name="Prefix">How the name begins.</param>
/// <param name="Suffix">How it ends; empty for anything.</param>
/// <param name="MetresPerStep">m: what a step of the stored values means, where the file does not say it.</param>
internal sealed record RasterProduct(string Prefix, string Suffix, double MetresPerStep);
