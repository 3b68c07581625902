using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Reads the label of an ISIS cube, with the pixels behind it or in a file of their own.</summary>
/// <remarks>USGS, ISIS Cube Format, and its special pixels (SpecialPixel.h).</remarks>
internal static class CubeLabel
{
    /// <summary>Special values of real pixels are below it.</summary>
    private const double LeastReal = -3.40282265e38;

    private static readonly string[] Groups = ["Instrument", "BandBin", "AlphaCube", "Archive", "Kernels"];

    /// <summary>Reads the label.</summary>
    /// <param name="text">Its text; what follows its End is not looked at.</param>
    /// <param name="path">Its file.</param>
    /// <exception cref="BadInputException">Something is missing or wrong.</exception>
    public static ImageLabel Read(string text, string path)
    {
        PdsObject label = PdsLabelParser.ParseCube(text, path);
        Dictionary<string, LabelValue> keywords = new(StringComparer.Ordinal);
        foreach (PdsObject group in Groups.Select(label.FindObject).OfType<PdsObject>())
        {
            foreach ((string name, PdsValue value) in group.Values)
            {
                keywords.TryAdd(ImageLabel.NameOf(name), ImageLabelReader.ValueOf(value));
            }
        }

        PdsObject? naif = label.FindObject("NaifKeywords");
        return new ImageLabel(path, keywords)
        {
            Kind = "ISIS cube",
            Pixels = PixelsOf(label, path),
            Naif = naif?.Values.ToDictionary(pair => pair.Key, pair => ImageLabelReader.ValueOf(pair.Value)) ?? [],
            Tables = new CubeTables(path, label),
        };
    }

    private static PixelLayout PixelsOf(PdsObject label, string path)
    {
        PdsObject core = Needed(label, "Core", path);
        PdsObject size = Needed(core, "Dimensions", path);
        PdsObject pixels = Needed(core, "Pixels", path);
        (int Bands, int Lines, int Samples) dimensions = (
            size.RequiredInteger("Bands", 1, ImageLabelReader.MostPixels), size.RequiredInteger("Lines", 1, ImageLabelReader.MostPixels),
            size.RequiredInteger("Samples", 1, ImageLabelReader.MostPixels));
        (PixelType type, Func<double, bool> isMissing) = pixels.RequiredText("Type") switch
        {
            "UnsignedByte" => (PixelType.Unsigned8, number => number is 0.0 or 255.0),
            "SignedWord" => (PixelType.Signed16, number => number < -32752.0),
            "UnsignedWord" => (PixelType.Unsigned16, number => number is < 3.0 or > 65522.0),
            "Real" => (PixelType.Real32, (Func<double, bool>)(number => number < LeastReal)),
            _ => throw pixels.WrongValue("Type", "UnsignedByte, SignedWord, UnsignedWord or Real is needed"),
        };
        bool isTiled = core.RequiredText("Format") switch
        {
            "Tile" => true,
            "BandSequential" => false,
            _ => throw core.WrongValue("Format", "Tile or BandSequential is needed"),
        };
        string file = core.Find("^Core") is { } other ? ImageLabelReader.Beside(path, other.Text) : path;
        PixelLayout layout = new(
            file, (long)core.RequiredNumber("StartByte") - 1, type, pixels.Find("ByteOrder")?.Text == "Msb", dimensions, default)
        {
            Tile = isTiled
                ? (core.RequiredInteger("TileLines", 1, ImageLabelReader.MostPixels),
                    core.RequiredInteger("TileSamples", 1, ImageLabelReader.MostPixels))
                : null,
            Base = pixels.OptionalNumber("Base") ?? 0.0,
            Multiplier = pixels.OptionalNumber("Multiplier") ?? 1.0,
            IsMissing = isMissing,
        };
        long line = (long)dimensions.Samples * layout.Bytes;
        return layout with { Strides = (line * dimensions.Lines, line, layout.Bytes) };
    }

    private static PdsObject Needed(PdsObject label, string name, string path) =>
        label.FindObject(name) ?? throw new BadInputException($"{path}: the cube's label has no {name}. Get the cube again.");
}
