using System.Text;
using System.Text.Json;
using System.Xml;
using System.Xml.Linq;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace Msisf.Adapters.Input;

/// <summary>
/// A node of a YAML, XML or JSON file of another program: a value, a list, or named nodes. Tags, attributes and comments are left out.
/// </summary>
/// <param name="Name">Its key or element; empty for an item of a list.</param>
/// <param name="Value">Its text; null for a list and for named nodes.</param>
/// <param name="Items">The nodes below it.</param>
/// <param name="Line">Line of its key, from 1.</param>
/// <param name="Column">Column of its key, from 1.</param>
internal sealed record FileTree(string Name, string? Value, IReadOnlyList<FileTree> Items, int Line, int Column)
{
    /// <summary>Nodes that a file may have: a camera has some hundred, and the states of a long scan a million.</summary>
    private const int MostNodes = 5_000_000;

    private const int MostLevels = 20;

    /// <summary>Reads a YAML file, the first document of it.</summary>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">It is not YAML.</exception>
    public static FileTree OfYaml(string text, string fileName)
    {
        YamlStream stream = [];
        try
        {
            stream.Load(new StringReader(text));
        }
        catch (Exception exception) when (exception is YamlException or InvalidOperationException or ArgumentException)
        {
            Mark place = (exception as YamlException)?.Start ?? Mark.Empty;
            throw new BadInputException(
                $"{fileName}, line {place.Line}, column {place.Column}: this is not YAML: {exception.Message.TrimEnd('.')}.", exception);
        }

        int left = MostNodes;
        return stream.Documents.Count > 0 ? Of(string.Empty, stream.Documents[0].RootNode, Mark.Empty, 0)
            : throw new BadInputException($"{fileName}: the file is empty.");

        FileTree Of(string name, YamlNode node, Mark key, int level)
        {
            Mark place = name.Length > 0 ? key : node.Start;
            if (--left < 0 || level > MostLevels)
            {
                throw new BadInputException($"{fileName}, line {place.Line}: too many values; this is not a calibration.");
            }

            IReadOnlyList<FileTree> items = node switch
            {
                YamlMappingNode map => [.. map.Children.Select(
                    pair => Of((pair.Key as YamlScalarNode)?.Value ?? string.Empty, pair.Value, pair.Key.Start, level + 1))],
                YamlSequenceNode list => [.. list.Children.Select(item => Of(string.Empty, item, item.Start, level + 1))],
                _ => [],
            };
            return new FileTree(name, (node as YamlScalarNode)?.Value, items, (int)place.Line, (int)place.Column);
        }
    }

    /// <summary>Reads an XML file.</summary>
    /// <inheritdoc cref="OfYaml"/>
    public static FileTree OfXml(string text, string fileName)
    {
        XmlReaderSettings safe = new() { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null, IgnoreComments = true };
        try
        {
            using XmlReader reader = XmlReader.Create(new StringReader(text.TrimStart('\uFEFF', ' ', '\r', '\n')), safe);
            return Of(XElement.Load(reader, LoadOptions.SetLineInfo));
        }
        catch (XmlException exception)
        {
            throw new BadInputException(
                $"{fileName}, line {exception.LineNumber}, column {exception.LinePosition}: this is not XML: {exception.Message}",
                exception);
        }

        static FileTree Of(XElement element) => new(
            element.Name.LocalName, element.HasElements ? null : element.Value.Trim(), [.. element.Elements().Select(Of)],
            ((IXmlLineInfo)element).LineNumber, ((IXmlLineInfo)element).LinePosition);
    }

    /// <summary>Reads a JSON file; its nodes do not know their lines.</summary>
    /// <inheritdoc cref="OfYaml"/>
    public static FileTree OfJson(string text, string fileName)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(text, new JsonDocumentOptions { AllowTrailingCommas = true });
            return Of(string.Empty, document.RootElement);
        }
        catch (JsonException exception)
        {
            throw new BadInputException(
                $"{fileName}, line {(exception.LineNumber ?? 0) + 1}: this is not JSON: {exception.Message}", exception);
        }

        static FileTree Of(string name, JsonElement element) => element.ValueKind switch
        {
            JsonValueKind.Object => new FileTree(
                name, null, [.. element.EnumerateObject().Select(member => Of(member.Name, member.Value))], 1, 1),
            JsonValueKind.Array => new FileTree(name, null, [.. element.EnumerateArray().Select(item => Of(string.Empty, item))], 1, 1),
            JsonValueKind.Null => new FileTree(name, null, [], 1, 1),
            _ => new FileTree(name, element.ToString(), [], 1, 1),
        };
    }

    /// <summary>The node of the first of some names that is there; null for none.</summary>
    /// <param name="names">Names in small letters without '_', '-', '.' and blanks, as all names are compared.</param>
    public FileTree? Find(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            if (Items.FirstOrDefault(item => Plain(item.Name) == name) is { } found)
            {
                return found;
            }
        }

        return null;
    }

    /// <summary>The numbers of a value, a list or lists of lists; blanks part them too. Null where one is not a finite number.</summary>
    public double[]? Numbers()
    {
        List<double> numbers = [];
        return Collect(this, numbers) ? [.. numbers] : null;

        static bool Collect(FileTree node, List<double> numbers)
        {
            foreach (string word in node.Value?.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries) ?? [])
            {
                if (!NumberText.TryParse(word, out double number))
                {
                    return false;
                }

                numbers.Add(number);
            }

            return node.Items.All(item => Collect(item, numbers));
        }
    }

    private static string Plain(string name)
    {
        StringBuilder plain = new(name.Length);
        foreach (char letter in name)
        {
            if (char.IsLetterOrDigit(letter))
            {
                plain.Append(char.ToLowerInvariant(letter));
            }
        }

        return plain.ToString();
    }
}
