using System.Xml;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>Reads from a meta file which files its frame was made from.</summary>
public static class MetaFileInputs
{
    /// <summary>Reads the Input elements; the pixels are not read.</summary>
    /// <param name="path">The meta file; it may be missing.</param>
    /// <returns>The files; none for a file that can't be read, is no meta file, or has no such elements (before version 3).</returns>
    public static IReadOnlyList<InputFile> Read(string path)
    {
        if (!File.Exists(path))
        {
            return [];
        }

        try
        {
            using FileStream stream = File.OpenRead(path);
            return Read(stream);
        }
        catch (Exception exception) when (exception is XmlException || exception.IsFileError())
        {
            return [];
        }
    }

    private static List<InputFile> Read(Stream stream)
    {
        List<InputFile> inputs = [];
        XmlReaderSettings settings = new() { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null };
        using XmlReader reader = XmlReader.Create(stream, settings);
        while (reader.Read() && reader.Name != "PixelInformation")
        {
            if (reader is { NodeType: XmlNodeType.Element, Name: OriginXml.InputElement } && TryInput(reader) is InputFile input)
            {
                inputs.Add(input);
            }
        }

        return inputs;
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
