using System.Text;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Msisf.Adapters.Input;

/// <summary>
/// Reads configuration files: one YAML map from keys to values or lists of values; in files that have sections also to such maps.
/// Everything
/// else in YAML (anchors, aliases, tags, several documents) is refused. Only this class and <see cref="FileTree"/> name YamlDotNet, so that
/// it is loaded only when there is a file to read.
/// </summary>
public sealed class ConfigFileReader
{
    /// <summary>Bytes. A configuration file has some hundred; a larger one is another kind of file.</summary>
    public const int LargestSize = 1_000_000;

    private static readonly string[] NullWords = ["", "~", "null", "Null", "NULL"];

    private readonly IParser _parser;
    private readonly string _fileName;
    private readonly int _levels;

    private ConfigFileReader(IParser parser, string fileName, int levels) =>
        (_parser, _fileName, _levels) = (parser, fileName, levels);

    /// <summary>Reads all entries.</summary>
    /// <param name="stream">UTF-8, with or without byte order mark; any line ends.</param>
    /// <param name="fileName">For messages.</param>
    /// <param name="levels">How many levels of keys may be below a key: 0 for values only.</param>
    /// <returns>In the order of the file; no key is there twice.</returns>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static IReadOnlyList<ConfigEntry> Read(Stream stream, string fileName, int levels = 0)
    {
        Parser parser = new(new StringReader(TextOf(stream, fileName)));
        try
        {
            return new ConfigFileReader(parser, fileName, levels).ReadDocument();
        }
        catch (YamlException exception)
        {
            throw NotYaml(fileName, exception.Start, exception.Message, exception);
        }
        catch (Exception exception) when (exception is InvalidOperationException or ArgumentException)
        {
            // YamlDotNet's scanner throws this at a list whose words go on in the next line.
            throw NotYaml(
                fileName, parser.Current?.End ?? Mark.Empty, "what begins here has no end; is there a ']' or '}' missing?", exception);
        }
    }

    private static BadInputException NotYaml(string fileName, Mark place, string why, Exception cause) =>
        new($"{fileName}, line {place.Line}, column {place.Column}: this is not YAML: {why.TrimEnd('.')}. A line is: key: value.", cause);

    private static string TextOf(Stream stream, string fileName)
    {
        byte[] bytes = new byte[LargestSize + 1];
        int count = stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false);
        if (count > LargestSize)
        {
            throw new BadInputException($"{fileName}: has more than {LargestSize} bytes; this is not a file of settings.");
        }

        try
        {
            UTF8Encoding strict = new(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);
            using StringReader decoded = new(strict.GetString(bytes, 0, count));
            BoundedLineReader lines = new(decoded, fileName);
            StringBuilder text = new(count);
            while (lines.TryRead(out ReadOnlySpan<char> line))
            {
                text.Append(line).Append('\n');
            }

            return text.ToString();
        }
        catch (DecoderFallbackException exception)
        {
            throw new BadInputException($"{fileName}: byte {exception.Index + 1} is not UTF-8 text. Save the file as UTF-8.", exception);
        }
    }

    private IReadOnlyList<ConfigEntry> ReadDocument()
    {
        _parser.Consume<StreamStart>();
        if (_parser.TryConsume<StreamEnd>(out _))
        {
            return [];
        }

        _parser.Consume<DocumentStart>();
        IReadOnlyList<ConfigEntry> entries = ReadRoot();
        _parser.Consume<DocumentEnd>();
        return _parser.TryConsume<StreamEnd>(out _)
            ? entries
            : throw Wrong(_parser.Current!, "a second YAML document begins; one is needed. Remove the line '---'");
    }

    private IReadOnlyList<ConfigEntry> ReadRoot()
    {
        ParsingEvent root = _parser.Current!;
        if (_parser.TryConsume<Scalar>(out Scalar? nothing) && IsNull(nothing))
        {
            return [];
        }

        if (!_parser.TryConsume<MappingStart>(out MappingStart? start))
        {
            throw Wrong(root, "a line 'key: value' is needed");
        }

        return ReadEntries(start, _levels);
    }

    private IReadOnlyList<ConfigEntry> ReadEntries(MappingStart start, int levels)
    {
        RefuseProperties(start);
        Dictionary<string, ConfigEntry> entries = new(StringComparer.Ordinal);
        while (!_parser.TryConsume<MappingEnd>(out _))
        {
            Scalar key = ReadScalar("a key is a single word");
            ConfigEntry entry = ReadEntry(key, levels);
            if (!entries.TryAdd(entry.Key, entry))
            {
                throw Wrong(key, $"{NumberText.Shown(entry.Key)} is there already, in line {entries[entry.Key].Line}. Leave one out");
            }
        }

        return [.. entries.Values];
    }

    private ConfigEntry ReadEntry(Scalar key, int levels)
    {
        (int line, int column) = ((int)key.Start.Line, (int)key.Start.Column);
        if (levels > 0 && _parser.TryConsume<MappingStart>(out MappingStart? section))
        {
            return new ConfigEntry(key.Value, [], IsList: false, line, column, ReadEntries(section, levels - 1));
        }

        (List<string> values, bool isList) = ReadValues(key.Value);
        return new ConfigEntry(key.Value, values, isList, line, column);
    }

    private (List<string> Values, bool IsList) ReadValues(string key)
    {
        string shownKey = NumberText.Shown(key);
        if (!_parser.TryConsume<SequenceStart>(out SequenceStart? list))
        {
            return ([ReadValue($"{shownKey} takes a value, or a list of values", shownKey)], false);
        }

        RefuseProperties(list);
        List<string> values = [];
        while (!_parser.TryConsume<SequenceEnd>(out _))
        {
            values.Add(ReadValue($"the list of {shownKey} holds single values only", shownKey));
        }

        return values.Count > 0 ? (values, true) : throw Wrong(list, $"the list of {shownKey} is empty. Fill it, or remove the key");
    }

    private string ReadValue(string whatIsNeeded, string shownKey)
    {
        Scalar value = ReadScalar(whatIsNeeded);
        if (IsNull(value))
        {
            throw Wrong(value, $"{shownKey} has no value. Give one, or remove the key");
        }

        return value.Value.Any(char.IsControl) || !IsWellFormed(value.Value)
            ? throw Wrong(value, $"the value of {shownKey} is not one line of text")
            : value.Value;
    }

    private Scalar ReadScalar(string whatIsNeeded)
    {
        if (!_parser.TryConsume<Scalar>(out Scalar? scalar))
        {
            throw Wrong(
                _parser.Current!, _parser.Current is AnchorAlias ? "aliases are not read here. Write the value itself" : whatIsNeeded);
        }

        RefuseProperties(scalar);
        return scalar;
    }

    private void RefuseProperties(NodeEvent node)
    {
        if (!node.Anchor.IsEmpty || !node.Tag.IsEmpty)
        {
            throw Wrong(node, "anchors and tags are not read here. Leave the word with '&' or '!' out, or put the value into quotes");
        }
    }

    private static bool IsNull(Scalar value) => value.Style == ScalarStyle.Plain && NullWords.Contains(value.Value, StringComparer.Ordinal);

    /// <summary>Whether each surrogate has its pair: "\\uD800" in quotes makes one without.</summary>
    private static bool IsWellFormed(string text) => !text.EnumerateRunes().Contains(Rune.ReplacementChar);

    private BadInputException Wrong(ParsingEvent place, string what) =>
        new($"{_fileName}, line {place.Start.Line}, column {place.Start.Column}: {what}.");
}

/// <summary>One key of a configuration file with its value or values, as text.</summary>
/// <param name="Key">As it is written.</param>
/// <param name="Values">
/// The value, or the values of a list; at least one, each a line without control characters. None if it has <paramref name="Entries"/>.
/// </param>
/// <param name="IsList">Whether it is written as a list.</param>
/// <param name="Line">Line of the key, from 1.</param>
/// <param name="Column">Column of the key, from 1.</param>
/// <param name="Entries">The keys below this one; null if it has values.</param>
public sealed record ConfigEntry(
    string Key, IReadOnlyList<string> Values, bool IsList, int Line, int Column, IReadOnlyList<ConfigEntry>? Entries = null);
