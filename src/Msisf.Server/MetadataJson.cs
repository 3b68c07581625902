using System.Text.Json;
using System.Xml;
using Msisf.Adapters.Metadata;
using Msisf.Core.Metadata;

namespace Msisf.Server;

/// <summary>
/// Writes a meta file as JSON with the same names: an element is an object, its attributes and elements are the members, numbers are
/// numbers, and the text of an element that has attributes is the member "value". Elements of which there may be several are lists.
/// </summary>
internal static class MetadataJson
{
    private static readonly string[] Lists =
        ["Pixel", "Input", "ElevationPart", "Crater", "CraterLeftOut", "Landmark", "Row", "OtherCamera", "Star", "SkyBody"];

    /// <summary>Attributes that stay texts, even if they look like a number.</summary>
    private static readonly string[] Texts = ["name", "id", "product", "sha256", "hiddenBy"];
    private static readonly XmlReaderSettings Reading = new() { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null };

    /// <param name="frame">What holds for the whole frame.</param>
    /// <param name="pixels">Its pixels, whose members do not go by way of the text in XML: that took most of the time.</param>
    public static void Write(Stream json, FrameMetadata frame, PixelSampler pixels, CancellationToken cancellation)
    {
        using MemoryStream xml = new();
        MetadataXmlWriter.WriteFrame(xml, frame, pixels, LongEDigits.RoundTrip);
        xml.Position = 0;
        Write(json, xml, writer => PixelJson.Write(writer, pixels, cancellation));
    }

    /// <summary>Writes the JSON of a meta file.</summary>
    /// <param name="xml">The meta file.</param>
    /// <param name="writePixels">Writes what the pixels hold in place of the file's; null for these.</param>
    internal static void Write(Stream json, Stream xml, Action<Utf8JsonWriter>? writePixels = null)
    {
        using XmlReader reader = XmlReader.Create(xml, Reading);
        using Utf8JsonWriter writer = new(json);
        reader.MoveToContent();
        WriteElement(writer, reader, writePixels);
    }

    /// <summary>Writes the element at which the reader is, which is at its end afterwards.</summary>
    private static void WriteElement(Utf8JsonWriter json, XmlReader reader, Action<Utf8JsonWriter>? writePixels)
    {
        if (reader.Name == "PixelInformation" && writePixels is not null)
        {
            writePixels(json);
            while (reader.Read() && reader.NodeType != XmlNodeType.EndElement)
            {
            }

            return;
        }

        bool isObject = reader.HasAttributes;
        bool isEmpty = reader.IsEmptyElement;
        if (isObject)
        {
            WriteAttributes(json, reader);
        }

        string text = string.Empty;
        string? list = null;
        while (!isEmpty && reader.Read() && reader.NodeType != XmlNodeType.EndElement)
        {
            if (reader.NodeType == XmlNodeType.Text)
            {
                text += reader.Value;
            }
            else if (reader.NodeType == XmlNodeType.Element)
            {
                if (!isObject)
                {
                    json.WriteStartObject();
                    isObject = true;
                }

                list = WriteName(json, reader.Name, list);
                WriteElement(json, reader, writePixels);
            }
        }

        if (list is not null)
        {
            json.WriteEndArray();
        }

        if (!isObject)
        {
            WriteText(json, text);
            return;
        }

        if (text.Length > 0)
        {
            json.WritePropertyName("value");
            WriteText(json, text);
        }

        json.WriteEndObject();
    }

    private static void WriteAttributes(Utf8JsonWriter json, XmlReader reader)
    {
        json.WriteStartObject();
        while (reader.MoveToNextAttribute())
        {
            json.WritePropertyName(reader.Name);
            if (Texts.Contains(reader.Name))
            {
                json.WriteStringValue(reader.Value);
            }
            else
            {
                WriteText(json, reader.Value);
            }
        }

        reader.MoveToElement();
    }

    /// <summary>Writes the name of a member, once for all elements of a list, which follow each other.</summary>
    /// <returns>The list that is open now; null for none.</returns>
    private static string? WriteName(Utf8JsonWriter json, string name, string? list)
    {
        if (list == name)
        {
            return list;
        }

        if (list is not null)
        {
            json.WriteEndArray();
        }

        json.WritePropertyName(name);
        if (!Lists.Contains(name))
        {
            return null;
        }

        json.WriteStartArray();
        return name;
    }

    /// <summary>A number, a list of numbers separated by blanks, or a text.</summary>
    private static void WriteText(Utf8JsonWriter json, string text)
    {
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double single) && double.IsFinite(single))
        {
            json.WriteNumberValue(single);
            return;
        }

        string[] words = text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        double[] numbers = new double[words.Length];
        for (int index = 0; index < words.Length; index++)
        {
            if (!double.TryParse(words[index], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[index])
                || !double.IsFinite(numbers[index]))
            {
                json.WriteStringValue(text);
                return;
            }
        }

        if (numbers.Length == 0)
        {
            json.WriteStringValue(text);
            return;
        }

        json.WriteStartArray();
        foreach (double number in numbers)
        {
            json.WriteNumberValue(number);
        }

        json.WriteEndArray();
    }
}
