using System.Xml;

namespace Msisf.Adapters.Metadata;

/// <summary>Reads from a meta file the arguments that make its frame.</summary>
public static class MetaFileCommand
{
    /// <summary>Reads the words of the CommandLine element; the pixels are not read.</summary>
    /// <returns>The words without their quotes; null for a file that is missing, can't be read, or has no such element.</returns>
    public static IReadOnlyList<string>? Read(string path)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            XmlReaderSettings settings = new() { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null };
            using XmlReader reader = XmlReader.Create(stream, settings);
            while (reader.Read() && reader.Name != "PixelInformation")
            {
                if (reader is { NodeType: XmlNodeType.Element, Name: "CommandLine" })
                {
                    return Words(reader.ReadElementContentAsString());
                }
            }
        }
        catch (Exception exception) when (exception is XmlException || exception.IsFileError())
        {
            return null;
        }

        return null;
    }

    private static string[] Words(string text)
    {
        string[] parts = text.Split('\'');
        return [.. parts.SelectMany((part, index) => index % 2 == 1 ? [part] : part.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
    }
}
