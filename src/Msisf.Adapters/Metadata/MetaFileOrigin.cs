using System.Xml;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>Reads from a meta file what its frame was made with. The pixels are not read; a file that can't be read says nothing.</summary>
public static class MetaFileOrigin
{
    /// <summary>The arguments that make the frame: the words of the CommandLine element, without their quotes.</summary>
    /// <param name="path">The meta file; it may be missing.</param>
    /// <returns>Null without such an element.</returns>
    public static IReadOnlyList<string>? Command(string path) =>
        Read(path, "CommandLine", most: 1, reader => Words(reader.ReadElementContentAsString())).FirstOrDefault();

    /// <summary>The files of the Input elements; none before version 3.</summary>
    /// <param name="path">The meta file; it may be missing.</param>
    public static IReadOnlyList<InputFile> Inputs(string path) => Read(path, OriginXml.InputElement, most: int.MaxValue, TryInput);

    private static List<T> Read<T>(string path, string element, int most, Func<XmlReader, T?> read)
        where T : class
    {
        List<T> found = [];
        if (!File.Exists(path))
        {
            return found;
        }

        try
        {
            using FileStream stream = File.OpenRead(path);
            using XmlReader reader = XmlReader.Create(
                stream, new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
            while (found.Count < most && reader.Read() && reader.Name != "PixelInformation")
            {
                if (reader.NodeType == XmlNodeType.Element && reader.Name == element && read(reader) is { } value)
                {
                    found.Add(value);
                }
            }
        }
        catch (Exception exception) when (exception is XmlException || exception.IsFileError())
        {
            return [];
        }

        return found;
    }

    private static string[] Words(string text)
    {
        string[] parts = text.Split('\'');
        return [.. parts.SelectMany((part, index) => index % 2 == 1 ? [part] : part.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
    }

    private static InputFile? TryInput(XmlReader reader)
    {
        string? word = reader.GetAttribute("kind");
        string? ofPieces = reader.GetAttribute(OriginXml.PiecesChecksum);
        InputKind[] kinds = [.. Enum.GetValues<InputKind>().Where(kind => OriginXml.WordOf(kind) == word)];
        return kinds.Length == 1
            && reader.GetAttribute("name") is string name
            && long.TryParse(reader.GetAttribute("bytes"), NumberStyles.None, CultureInfo.InvariantCulture, out long bytes)
            && (ofPieces ?? reader.GetAttribute(OriginXml.Checksum)) is string hash
            ? new InputFile(kinds[0], name, bytes, hash) { IsOfPieces = ofPieces is not null }
            : null;
    }
}
