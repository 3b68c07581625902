using System.Xml;
using System.Xml.Linq;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Reads a PDS4 label with an image of two or three axes.</summary>
/// <remarks>PDS4 Information Model 1.11 and later: Array_2D_Image, Array_3D_Image, Array_3D_Spectrum, the last axis fastest.</remarks>
internal static class Pds4ImageLabel
{
    private static readonly Dictionary<string, (PixelType Type, bool IsBigEndian)> Types = new(StringComparer.Ordinal)
    {
        ["UnsignedByte"] = (PixelType.Unsigned8, false),
        ["UnsignedLSB2"] = (PixelType.Unsigned16, false),
        ["UnsignedMSB2"] = (PixelType.Unsigned16, true),
        ["SignedLSB2"] = (PixelType.Signed16, false),
        ["SignedMSB2"] = (PixelType.Signed16, true),
        ["SignedLSB4"] = (PixelType.Signed32, false),
        ["SignedMSB4"] = (PixelType.Signed32, true),
        ["IEEE754LSBSingle"] = (PixelType.Real32, false),
        ["IEEE754MSBSingle"] = (PixelType.Real32, true),
        ["IEEE754LSBDouble"] = (PixelType.Real64, false),
        ["IEEE754MSBDouble"] = (PixelType.Real64, true),
    };

    /// <summary>Reads the label.</summary>
    /// <param name="path">Its file.</param>
    /// <exception cref="BadInputException">Something is missing or wrong.</exception>
    public static ImageLabel Read(XElement root, string path)
    {
        XElement area = Below(root, "File_Area_Observational").FirstOrDefault()
            ?? throw new BadInputException($"{path}: no File_Area_Observational: no PDS4 label of an image. Give the one of an image.");
        XElement array = area.Elements().FirstOrDefault(part => part.Name.LocalName.StartsWith("Array_", StringComparison.Ordinal))
            ?? throw new BadInputException($"{path}: the label has no array (Array_2D_Image, ...). Give the label of an image.");
        Dictionary<string, LabelValue> keywords = new(StringComparer.Ordinal);
        foreach (XElement leaf in root.Descendants().Where(part => !part.HasElements && part.Value.Trim().Length > 0))
        {
            keywords.TryAdd(
                ImageLabel.NameOf(leaf.Name.LocalName), new LabelValue([leaf.Value.Trim()], leaf.Attribute("unit")?.Value));
        }

        // Elements of the same name hold the names of the observing system's parts and of the target.
        Put(keywords, "INSTRUMENTNAME", Below(root, "Observing_System_Component"), path);
        Put(keywords, "TARGETNAME", Below(root, "Target_Identification"), path);
        Rename(keywords, "STARTDATETIME", "STARTTIME");
        return new ImageLabel(path, keywords) { Kind = "PDS4", Pixels = PixelsOf(area, array, path) };
    }

    private static void Put(Dictionary<string, LabelValue> keywords, string name, IEnumerable<XElement> parts, string path)
    {
        string[] names = [.. parts.Select(part => Text(part, "name", path))];
        if (names.Length > 0)
        {
            keywords[name] = new LabelValue([string.Join(' ', names)]);
        }
    }

    private static void Rename(Dictionary<string, LabelValue> keywords, string from, string to)
    {
        if (keywords.TryGetValue(from, out LabelValue? value))
        {
            keywords[to] = value;
        }
    }

    private static PixelLayout PixelsOf(XElement area, XElement array, string path)
    {
        (string Name, int Size)[] axes = [.. Below(array, "Axis_Array")
            .OrderBy(axis => Whole(axis, "sequence_number", path))
            .Select(axis => (Text(axis, "axis_name", path).ToUpperInvariant(), Whole(axis, "elements", path)))];
        string typeName = Text(array, "data_type", path);
        (PixelType type, bool isBigEndian) = Types.TryGetValue(typeName, out (PixelType, bool) known)
            ? known
            : throw new BadInputException($"{path}: data_type is {typeName}; {string.Join(", ", Types.Keys)} are read.");
        string file = ImageLabelReader.Beside(path, Text(Below(area, "File").First(), "file_name", path));
        int SizeOf(string name) => Array.Find(axes, axis => axis.Name == name).Size;
        (int lines, int samples) = (SizeOf("LINE"), SizeOf("SAMPLE"));
        if (axes.Length is < 2 or > 3 || lines == 0 || samples == 0)
        {
            throw new BadInputException(
                $"{path}: the axes of the array are {string.Join(", ", axes.Select(axis => axis.Name))}; Line, Sample and perhaps Band are "
                    + "needed.");
        }

        string[] noBand = ["LINE", "SAMPLE"];
        int bands = axes.Where(axis => !noBand.Contains(axis.Name)).Select(axis => axis.Size).DefaultIfEmpty(1).First();
        PixelLayout layout = new(file, Whole(array, "offset", path), type, isBigEndian, (bands, lines, samples), default)
        {
            Base = Number(array, "value_offset") ?? 0.0,
            Multiplier = Number(array, "scaling_factor") ?? 1.0,
            IsMissing = MissingOf(array),
        };
        Dictionary<string, long> strides = [];
        long stride = layout.Bytes;
        foreach ((string name, int size) in axes.Reverse())
        {
            strides[noBand.Contains(name) ? name : "BAND"] = stride;
            stride *= size;
        }

        return layout with { Strides = (strides.GetValueOrDefault("BAND", stride), strides["LINE"], (int)strides["SAMPLE"]) };
    }

    private static Func<double, bool> MissingOf(XElement array)
    {
        double[] values = [.. Below(array, "Special_Constants").SelectMany(constants => constants.Elements())
            .Select(constant => double.TryParse(
                constant.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN)];
        return number => values.Contains(number);
    }

    private static IEnumerable<XElement> Below(XElement root, string name) =>
        root.Descendants().Where(part => part.Name.LocalName == name);

    private static string Text(XElement part, string name, string path) => Below(part, name).FirstOrDefault()?.Value.Trim()
        ?? throw new BadInputException(
            $"{path}, line {((IXmlLineInfo)part).LineNumber}: {part.Name.LocalName} has no {name}. Get the label again.");

    private static int Whole(XElement part, string name, string path) =>
        int.TryParse(Text(part, name, path), NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            && (number is > 0 and <= ImageLabelReader.MostPixels || name == "offset")
            ? number
            : throw new BadInputException($"{path}: {name} is '{Text(part, name, path)}'; a whole number is needed.");

    private static double? Number(XElement part, string name) => double.TryParse(
        Below(part, name).FirstOrDefault()?.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;
}
