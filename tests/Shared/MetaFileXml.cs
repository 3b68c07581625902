using System.Xml;
using System.Xml.Linq;

namespace Msisf.TestSupport;

/// <summary>Meta files as a validating parser reads them.</summary>
internal static class MetaFileXml
{
    /// <summary>Parses and validates against lib/MSISRendering.dtd.</summary>
    public static XDocument Parse(string xml)
    {
        string dtd = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd"));
        string withDtd = xml.Replace("SYSTEM \"../lib/MSISRendering.dtd\"", $"[\n{dtd}]", StringComparison.Ordinal)
            .Replace("standalone=\"no\" ", string.Empty, StringComparison.Ordinal);
        XmlReaderSettings settings = new() { DtdProcessing = DtdProcessing.Parse, ValidationType = ValidationType.DTD };
        using XmlReader reader = XmlReader.Create(new StringReader(withDtd), settings);
        return XDocument.Load(reader);
    }
}
