using System.Text;
using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Tells by the content of a file who reads it: GDAL, or the reader of LOLA's PDS3 products.</summary>
public static class RasterFiles
{
    /// <summary>How the names of GDAL's virtual files begin: in archives, or on other computers.</summary>
    private const string VirtualPrefix = "/vsi";

    /// <summary>Bytes in which a file says what it is.</summary>
    private const int HeadBytes = 64;

    /// <summary>With what files of other formats begin whose names end like those of PDS3.</summary>
    private static readonly string[] OtherHeads = ["EHFA_HEADER_TAG", "Object = IsisCube"];

    /// <summary>Whether a path is one of GDAL's virtual files, e.g. "/vsicurl/https://...".</summary>
    public static bool IsVirtual(string path) => path.StartsWith(VirtualPrefix, StringComparison.Ordinal);

    /// <summary>Whether a path is an address as of a browser, which GDAL reads under another name.</summary>
    public static bool IsAddress(string path) =>
        path.StartsWith("http://", StringComparison.OrdinalIgnoreCase) || path.StartsWith("https://", StringComparison.OrdinalIgnoreCase);

    /// <summary>Whether there is such a file; a missing virtual one is reported when it is opened.</summary>
    public static bool Exists(string path) => IsVirtual(path) || File.Exists(path);

    /// <summary>Opens a file to be read, a virtual one too.</summary>
    /// <exception cref="IOException">It can't be opened.</exception>
    internal static Stream OpenRead(string path) => IsVirtual(path) ? new GdalStream(path) : File.OpenRead(path);

    /// <summary>Whether GDAL reads an elevation model; a missing file is judged by its name.</summary>
    /// <param name="path">A file or a folder.</param>
    public static bool IsForGdal(string path)
    {
        if (IsVirtual(path) || IsAddress(path))
        {
            return true;
        }

        if (!File.Exists(path))
        {
            return Path.GetExtension(path).ToUpperInvariant() is ".TIF" or ".TIFF" or ".VRT" or ".CUB" or ".JP2" or ".XML";
        }

        string label = FileNames.LabelOf(path);
        return IsPdsLabel(label) ? !IsForPdsReader(label)
            : BareImage.LabelOf(path) is null && (!IsNameOfPdsFile(path) || HasOtherHead(path));
    }

    /// <summary>Name of the model in a file: the file's.</summary>
    public static string ProductIdOf(string path) => Path.GetFileNameWithoutExtension(path);

    /// <summary>What GDAL opens of a PDS3 product: its label, whichever of its two files is named.</summary>
    internal static string LabelOrFile(string path) =>
        !IsVirtual(path) && FileNames.LabelOf(path) is var label && IsPdsLabel(label) ? label : path;

    /// <summary>Labels like LOLA's are read here, with messages about errors in LOLA's own; GDAL reads all others.</summary>
    private static bool IsForPdsReader(string label)
    {
        try
        {
            LdemLabelReader.ReadFile(label);
            return true;
        }
        catch (BadInputException)
        {
            return RasterProducts.Find(label) is null && LdemLabelReader.IsOfReader(label);
        }
    }

    /// <summary>The PDS3 reader reports a damaged image or label.</summary>
    private static bool IsNameOfPdsFile(string path) => Path.GetExtension(path).ToUpperInvariant() is ".IMG" or ".LBL" or ".LAB";

    private static bool IsPdsLabel(string path) => PdsLabelParser.IsLabel(Head(path));

    /// <summary>
    /// Whether a file named like one of PDS3 is of another format after all: ERDAS's files end in .img too, labels of ISIS in .lbl.
    /// </summary>
    private static bool HasOtherHead(string path) =>
        Array.Exists(OtherHeads, start => Head(path).TrimStart().StartsWith(start, StringComparison.Ordinal));

    private static string Head(string path)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            byte[] head = new byte[HeadBytes];
            return Encoding.Latin1.GetString(head, 0, stream.ReadAtLeast(head, HeadBytes, throwOnEndOfStream: false));
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return string.Empty; // who reads the file says what is wrong
        }
    }
}

/// <summary>
/// Products whose files do not say all that is needed to read their heights; the name says it. From the products' documents: the files
/// themselves were not at hand (docs/surface.md).
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

        // JAXA's tiles of Kaguya's Terrain Camera, DTM_MAP_02 and DTM_MAPs02: 16-bit integers in m over 1737.4 km.
        new("DTM_MAP", string.Empty, MetresPerStep: 1.0),

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
