using System.Text.RegularExpressions;
using System.Xml;
using System.Xml.Linq;

namespace Msisf.TestSupport;

/// <summary>Meta files as a validating parser reads them.</summary>
internal static partial class MetaFileXml
{
    /// <summary>Parses and validates against lib/MSISRendering.dtd, whatever grammar the file has itself.</summary>
    public static XDocument Parse(string xml)
    {
        string dtd = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd"));
        string withDtd = OwnGrammar().Replace(xml, _ => $"MSISRendering [\n{dtd}\n]>", 1)
            .Replace("standalone=\"no\" ", string.Empty, StringComparison.Ordinal);
        XmlReaderSettings settings = new() { DtdProcessing = DtdProcessing.Parse, ValidationType = ValidationType.DTD };
        using XmlReader reader = XmlReader.Create(new StringReader(withDtd), settings);
        return XDocument.Load(reader);
    }

    [GeneratedRegex(@"MSISRendering \[.*?\n\]>", RegexOptions.Singleline)]
    private static partial Regex OwnGrammar();
}
