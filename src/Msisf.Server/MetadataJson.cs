using System.Globalization;
using System.Text.Json;
using System.Xml;

namespace Msisf.Server;

/// <summary>
/// Writes a meta file as JSON with the same names: an element is an object, its attributes and elements are the members, numbers are
/// numbers, and the text of an element that has attributes is the member "value". Elements of which there may be several are lists.
/// </summary>
internal static class MetadataJson
{
    private static readonly string[] Lists = ["Pixel", "Input", "Crater", "CraterLeftOut", "Landmark"];

    /// <summary>Attributes that stay texts, even if they look like a number.</summary>
    private static readonly string[] Texts = ["name", "id", "product", "sha256", "hiddenBy"];
    private static readonly XmlReaderSettings Reading = new() { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null };

    /// <summary>Writes the JSON.</summary>
    /// <param name="json">Receives it.</param>
    /// <param name="xml">The meta file.</param>
    public static void Write(Stream json, Stream xml)
    {
        XmlDocument document = new() { XmlResolver = null };
        using XmlReader reader = XmlReader.Create(xml, Reading);
        document.Load(reader);
        using Utf8JsonWriter writer = new(json);
        WriteElement(writer, document.DocumentElement!);
    }

    private static void WriteElement(Utf8JsonWriter json, XmlElement element)
    {
        XmlElement[] children = [.. element.ChildNodes.OfType<XmlElement>()];
        if (children.Length == 0 && element.Attributes.Count == 0)
        {
            WriteText(json, element.InnerText);
            return;
        }

        json.WriteStartObject();
        foreach (XmlAttribute attribute in element.Attributes)
        {
            json.WritePropertyName(attribute.Name);
            if (Texts.Contains(attribute.Name))
            {
                json.WriteStringValue(attribute.Value);
            }
            else
            {
                WriteText(json, attribute.Value);
            }
        }

        foreach (IGrouping<string, XmlElement> same in children.GroupBy(child => child.Name))
        {
            json.WritePropertyName(same.Key);
            if (!Lists.Contains(same.Key))
            {
                WriteElement(json, same.First());
                continue;
            }

            json.WriteStartArray();
            foreach (XmlElement child in same)
            {
                WriteElement(json, child);
            }

            json.WriteEndArray();
        }

        if (children.Length == 0 && element.InnerText.Trim().Length > 0)
        {
            json.WritePropertyName("value");
            WriteText(json, element.InnerText);
        }

        json.WriteEndObject();
    }

    /// <summary>A number, a list of numbers separated by blanks, or a text.</summary>
    private static void WriteText(Utf8JsonWriter json, string text)
    {
        string[] words = text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        double[] numbers = [.. words.Select(word =>
            double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN)];
        if (numbers.Length == 0 || !numbers.All(double.IsFinite))
        {
            json.WriteStringValue(text);
        }
        else if (numbers.Length == 1)
        {
            json.WriteNumberValue(numbers[0]);
        }
        else
        {
            json.WriteStartArray();
            foreach (double number in numbers)
            {
                json.WriteNumberValue(number);
            }

            json.WriteEndArray();
        }
    }
}
