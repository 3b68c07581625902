using System.Net;
using System.Xml;
using System.Xml.Schema;
using Msisf.Adapters.Render;

namespace Msisf.Adapters.Manifest;

/// <summary>Checks whether an output file is complete by its own format.</summary>
/// <param name="metaFileDtd">lib/MSISRendering.dtd of the installation.</param>
public sealed class FileStructure(string metaFileDtd)
{
    /// <summary>A meta file has no entities of its own.</summary>
    private const long MaxCharactersFromEntities = 100_000;

    /// <summary>Checks an image or a meta file; other files are not checked.</summary>
    /// <returns>What is wrong with it; null if nothing is.</returns>
    /// <exception cref="IOException">It can't be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It can't be read.</exception>
    public string? ProblemWith(string path) => Path.GetExtension(path) switch
    {
        ".png" => ImageProblem(path),
        ".xml" => MetaFileProblem(path),
        _ => null,
    };

    private static string? ImageProblem(string path)
    {
        string named = $"{Path.GetFileName(path)}: ";
        try
        {
            using FileStream stream = File.OpenRead(path);
            PngFile.Check(stream, Path.GetFileName(path));
            return null;
        }
        catch (BadInputException exception)
        {
            // Who asks names the file already.
            return exception.Message.StartsWith(named, StringComparison.Ordinal) ? exception.Message[named.Length..] : exception.Message;
        }
    }

    private string? MetaFileProblem(string path)
    {
        XmlReaderSettings settings = new()
        {
            DtdProcessing = DtdProcessing.Parse,
            ValidationType = ValidationType.DTD,
            XmlResolver = new MetaFileDtd(metaFileDtd),
            MaxCharactersFromEntities = MaxCharactersFromEntities,
        };
        try
        {
            using FileStream stream = File.OpenRead(path);
            using XmlReader reader = XmlReader.Create(stream, settings);
            while (reader.Read())
            {
                continue; // the reader checks as it goes
            }

            return null;
        }
        catch (Exception exception) when (exception is XmlException or XmlSchemaException)
        {
            return $"not a valid meta file: {exception.Message}";
        }
    }
}

/// <summary>
/// Resolves the DTD of a meta file to the installed one, wherever the meta file lies, and resolves nothing else, so that no file can make
/// others be read.
/// </summary>
/// <param name="path">lib/MSISRendering.dtd of the installation.</param>
internal sealed class MetaFileDtd(string path) : XmlResolver
{
    public override ICredentials Credentials
    {
        set { }
    }

    public override object GetEntity(Uri absoluteUri, string? role, Type? ofObjectToReturn) =>
        Path.GetFileName(absoluteUri.AbsolutePath) == Path.GetFileName(path)
            ? File.OpenRead(path)
            : throw new XmlException($"it wants {absoluteUri.AbsolutePath}, which is not the DTD of meta files");
}
