using System.Xml;
using System.Xml.Linq;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Reads the label of a real image, attached or detached.</summary>
public static class ImageLabelReader
{
    /// <summary>Bytes: labels are shorter.</summary>
    private const int LongestLabel = 1 << 22;

    /// <summary>Samples or lines at most, of an image that is read.</summary>
    internal const int MostPixels = 10_000_000;

    /// <summary>Reads a label.</summary>
    /// <param name="path">An ISIS cube or its label, a PDS3 product or its label, or a PDS4 label.</param>
    /// <exception cref="BadInputException">It is none of them, or can't be read.</exception>
    public static ImageLabel Read(string path)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException(Directory.Exists(path)
                ? $"{path}: is a folder; the label of an image is needed."
                : $"{path}: there is no such file.");
        }

        string text = FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            return PdsLabelParser.TextOf(stream, LongestLabel);
        });
        string start = text.TrimStart('\uFEFF', 'ï', '»', '¿', ' ', '\r', '\n', '\t');
        return start.StartsWith("Object = IsisCube", StringComparison.OrdinalIgnoreCase) ? CubeLabel.Read(text, path)
            : PdsLabelParser.IsLabel(text) ? Pds3ImageLabel.Read(start, path)
            : start.StartsWith('<') ? Pds4ImageLabel.Read(Xml(path), path)
            : throw new BadInputException(
                $"{path}: it begins as none of the labels that are known: an ISIS cube (Object = IsisCube), PDS3 (PDS_VERSION_ID), PDS4 "
                    + "(XML). Give the label of the image.");
    }

    /// <summary>A file that a label names: its plain name, beside the label.</summary>
    internal static string Beside(string path, string name) =>
        Path.Combine(Path.GetDirectoryName(path) ?? string.Empty, Path.GetFileName(name.Replace('\\', '/')));

    /// <summary>The items of a value as texts.</summary>
    internal static LabelValue ValueOf(PdsValue value) => value.Items is { } items
        ? new LabelValue([.. items.Select(item => item.Text)], value.Unit ?? (items.Count > 0 ? items[^1].Unit : null))
        : new LabelValue([value.Text], value.Unit);

    private static XElement Xml(string path)
    {
        try
        {
            using XmlReader reader = XmlReader.Create(
                path, new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
            return XElement.Load(reader, LoadOptions.SetLineInfo);
        }
        catch (XmlException exception)
        {
            throw new BadInputException($"{path}, line {exception.LineNumber}: no XML: {exception.Message}", exception);
        }
    }
}
