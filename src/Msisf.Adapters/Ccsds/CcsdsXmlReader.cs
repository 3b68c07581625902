using System.Xml;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ccsds;

/// <summary>Reads the form of XML.</summary>
/// <remarks>CCSDS 505.0-B.</remarks>
/// <param name="message">Takes what is read.</param>
internal sealed class CcsdsXmlReader(CcsdsMessage message)
{
    private const int MostNumbers = 16;

    private readonly CcsdsPlace _place = message.Place;
    private readonly double[] _numbers = new double[MostNumbers];

    /// <summary>Reads a file to its end.</summary>
    public void Read(TextReader text)
    {
        XmlReaderSettings settings = new()
        {
            DtdProcessing = DtdProcessing.Prohibit,
            IgnoreComments = true,
            IgnoreWhitespace = true,
            IgnoreProcessingInstructions = true,
        };
        try
        {
            using XmlReader xml = XmlReader.Create(text, settings);
            ReadMessages(xml);
        }
        catch (XmlException exception)
        {
            _place.Line = Math.Max(_place.Line, exception.LineNumber);
            throw _place.Error($"this is not valid XML: {exception.Message}", exception);
        }
    }

    private void ReadMessages(XmlReader xml)
    {
        string element = message.Kind.ToLowerInvariant();
        bool isFound = false;
        while (ReadOn(xml))
        {
            if (xml.NodeType != XmlNodeType.Element || xml.LocalName == "ndm")
            {
                continue;
            }

            if (xml.LocalName != element)
            {
                if (xml.Depth == 0)
                {
                    throw _place.Error($"this is not an {message.Kind}: it begins with <{xml.LocalName}>, <{element}> is needed.");
                }

                SkipWithin(xml);
                continue;
            }

            isFound = true;
            ReadMessage(xml);
        }

        if (!isFound)
        {
            throw _place.Error($"there is no <{element}> in it.");
        }
    }

    private void ReadMessage(XmlReader xml)
    {
        message.TakeHeader(message.VersionKeyword, xml.GetAttribute("version") ?? string.Empty);
        int depth = xml.Depth;
        bool hasBlock = false;
        while (ReadOn(xml) && xml.Depth > depth)
        {
            if (xml.NodeType == XmlNodeType.Element && xml.LocalName == "segment")
            {
                hasBlock = true;
                ReadSegment(xml);
            }
        }

        if (!hasBlock)
        {
            throw _place.Error("there is no <segment> in it.");
        }
    }

    private void ReadSegment(XmlReader xml)
    {
        message.BeginBlock();
        int depth = xml.Depth;
        bool hasData = false;
        while (ReadOn(xml) && xml.Depth > depth)
        {
            if (xml.NodeType != XmlNodeType.Element || xml.LocalName == "metadata")
            {
                continue;
            }

            if (xml.LocalName == "data")
            {
                message.BeginData();
                hasData = true;
            }
            else if (xml.LocalName is "stateVector" or "attitudeState" && hasData)
            {
                ReadState(xml);
            }
            else if (hasData)
            {
                SkipWithin(xml);
            }
            else
            {
                string key = xml.LocalName;
                string value = TextOf(xml);
                if (key != "COMMENT")
                {
                    message.TakeMetadata(key, value);
                }
            }
        }

        if (!hasData)
        {
            throw _place.Error("a <segment> has no <data>.");
        }

        message.EndBlock();
    }

    private void ReadState(XmlReader xml)
    {
        int depth = xml.Depth;
        string? epoch = null;
        string parent = xml.LocalName;
        Array.Fill(_numbers, double.NaN);
        int count = 0;
        while (ReadOn(xml) && xml.Depth > depth)
        {
            if (xml.NodeType != XmlNodeType.Element)
            {
                continue;
            }

            string name = xml.LocalName;
            string? axis = xml.GetAttribute("angle") ?? xml.GetAttribute("rate");
            string? unit = xml.GetAttribute("units");
            bool isLeaf = !char.IsLower(name[0]) || name is "rotation1" or "rotation2" or "rotation3";
            if (!isLeaf)
            {
                parent = name;
                continue;
            }

            string value = TextOf(xml);
            if (name == "EPOCH")
            {
                epoch = value;
            }
            else if (name != "COMMENT")
            {
                int index = IndexOf(parent, name, axis, unit);
                _numbers[index] = _place.Number(value);
                count = Math.Max(count, index + 1);
            }
        }

        if (epoch is null || _numbers.AsSpan(0, count).Contains(double.NaN))
        {
            throw _place.Error($"a <{parent}> above is not complete. Complete or remove it.");
        }

        message.TakeData(epoch, _numbers.AsSpan(0, count), areNamed: true);
    }

    private int IndexOf(string parent, string name, string? axis, string? unit)
    {
        (int index, string expected) = _place.Located(() => message.PlaceOf(parent, name, axis));
        if (index is < 0 or >= MostNumbers)
        {
            throw _place.Error($"{NumberText.Shown(name)} is not known in <{parent}>.");
        }

        return unit is null || unit.Equals(expected, StringComparison.OrdinalIgnoreCase)
            ? index
            : throw _place.Error($"{name} is in {NumberText.Shown(unit)}; the standard has {expected}.");
    }

    /// <summary>The text of an element, whose end is then the reader's node.</summary>
    private string TextOf(XmlReader xml)
    {
        if (xml.IsEmptyElement)
        {
            return string.Empty;
        }

        int depth = xml.Depth;
        string text = string.Empty;
        while (ReadOn(xml) && xml.Depth > depth)
        {
            text += xml.NodeType is XmlNodeType.Text or XmlNodeType.CDATA
                ? xml.Value
                : throw _place.Error(Invariant($"<{xml.LocalName}> does not belong here."));
        }

        return text.Trim();
    }

    private void SkipWithin(XmlReader xml)
    {
        int depth = xml.Depth;
        if (!xml.IsEmptyElement)
        {
            while (ReadOn(xml) && xml.Depth > depth)
            {
            }
        }
    }

    private bool ReadOn(XmlReader xml)
    {
        bool isThere = xml.Read();
        _place.Line = xml is IXmlLineInfo { LineNumber: > 0 } line ? line.LineNumber : _place.Line;
        return isThere;
    }
}
