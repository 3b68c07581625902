using System.Net;
using System.Xml;

namespace Msisf.Adapters.Manifest;

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
