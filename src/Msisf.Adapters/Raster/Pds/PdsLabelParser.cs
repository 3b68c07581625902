using System.Text;

namespace Msisf.Adapters.Raster.Pds;

/// <summary>
/// Reads a PDS3 label, attached or detached: nested objects, comments, texts, sequences and sets over several lines, units. The labels of
/// ISIS cubes are written the same way, with small letters.
/// </summary>
/// <remarks>Planetary Data System Standards Reference 3.8, chapters 5 and 12.</remarks>
internal sealed class PdsLabelParser
{
    private static readonly string[] FirstKeywords = ["PDS_VERSION_ID", "CCSD3ZF0000100000001NJPL3IF0PDSX00000001"];

    private readonly PdsTokenizer _tokens;
    private readonly string _file;
    private PdsToken _token;

    private PdsLabelParser(string text, string file)
    {
        _file = file;
        _tokens = new PdsTokenizer(text, file);
        _token = _tokens.Next();
    }

    /// <summary>The text with which a file begins.</summary>
    /// <param name="stream">The file, where its label begins.</param>
    /// <param name="limit">Bytes: labels are shorter; of an attached image no more than this is read.</param>
    public static string TextOf(Stream stream, int limit)
    {
        byte[] bytes = new byte[stream.CanSeek ? Math.Min(limit, stream.Length - stream.Position) : limit];
        return Encoding.Latin1.GetString(bytes, 0, stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false));
    }

    /// <summary>Whether a text begins as a PDS3 label, with or without the mark of a standard formatted data unit.</summary>
    public static bool IsLabel(string text)
    {
        string start = text.TrimStart('\uFEFF', 'ï', '»', '¿', ' ', '\r', '\n', '\t');
        return start.StartsWith("PDS_VERSION_ID", StringComparison.OrdinalIgnoreCase)
            || start.StartsWith("CCSD3ZF", StringComparison.OrdinalIgnoreCase);
    }

    /// <summary>Reads a label up to its END.</summary>
    /// <param name="text">The label; what follows END (an attached image) is not looked at.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="BadInputException">The text is not a PDS3 label; the message names file and line.</exception>
    public static PdsObject Parse(string text, string file)
    {
        PdsLabelParser parser = new(text, file);
        if (parser._token.Kind != PdsTokenKind.Word || !FirstKeywords.Contains(parser._token.Text, StringComparer.OrdinalIgnoreCase))
        {
            bool isIsis2 = IsLabel(text) && text.Contains("^QUBE", StringComparison.Ordinal);
            throw new BadInputException(isIsis2
                ? $"{file}: a cube of ISIS 2, which is not read. Give the PDS product that it was made from, or a cube of ISIS 3 or later."
                : $"{file}: not a PDS3 label (it does not begin with PDS_VERSION_ID). Give the .LBL file that belongs to it.");
        }

        return parser.ReadLabel();
    }

    /// <summary>Reads the label of an ISIS cube up to its End.</summary>
    /// <param name="text">The label; what follows End is not looked at.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="BadInputException">The text is not a label; the message names file and line.</exception>
    public static PdsObject ParseCube(string text, string file) => new PdsLabelParser(text, file).ReadLabel();

    private PdsObject ReadLabel()
    {
        PdsObject label = new(_file, "the label", 1);
        ReadStatements(label, closing: null);
        return label;
    }

    private void ReadStatements(PdsObject target, string? closing)
    {
        while (true)
        {
            PdsToken keyword = Take(PdsTokenKind.Word, "a keyword");
            string word = keyword.Text.ToUpperInvariant();
            if (word is "END" or "END_OBJECT" or "END_GROUP")
            {
                ReadEnd(keyword, target, closing);
                return;
            }

            TakeSign("=", $"'=' after {keyword.Text}");
            PdsValue value = ReadValue();
            if (word is "OBJECT" or "GROUP")
            {
                PdsObject child = new(_file, value.Text, keyword.Line);
                ReadStatements(child, "END_" + word);
                target.Add(child);
            }
            else
            {
                target.Add(keyword.Text, value);
            }
        }
    }

    private void ReadEnd(PdsToken keyword, PdsObject target, string? closing)
    {
        string need = closing is null
            ? "no object is open here"
            : $"{closing} = {target.Name} is needed first (line {target.Line} opens it)";
        if (!keyword.Text.Equals(closing ?? "END", StringComparison.OrdinalIgnoreCase))
        {
            throw Wrong(keyword, need);
        }

        if (closing is not null && _token.IsSign("="))
        {
            Advance();
            PdsToken name = Take(PdsTokenKind.Word, "an object's name");
            if (!name.Text.Equals(target.Name, StringComparison.OrdinalIgnoreCase))
            {
                throw Wrong(name, need);
            }
        }
    }

    private PdsValue ReadValue()
    {
        PdsToken first = _token;
        List<PdsValue>? items = null;
        if (first.IsSign("(") || first.IsSign("{"))
        {
            items = ReadItems(first.Text == "(" ? ")" : "}");
        }
        else if (first.Kind is not (PdsTokenKind.Word or PdsTokenKind.Quoted))
        {
            throw Wrong(first, "a value is needed");
        }
        else
        {
            Advance();
        }

        string? unit = null;
        if (_token.Kind == PdsTokenKind.Unit)
        {
            unit = _token.Text.Trim();
            Advance();
        }

        return new PdsValue(items is null ? first.Text.Trim() : string.Empty, first.Kind == PdsTokenKind.Quoted, unit, items, first.Line);
    }

    private List<PdsValue> ReadItems(string closing)
    {
        List<PdsValue> items = [];
        Advance();
        while (!_token.IsSign(closing))
        {
            if (items.Count > 0)
            {
                TakeSign(",", $"',' or '{closing}'");
            }

            items.Add(ReadValue());
        }

        Advance();
        return items;
    }

    private PdsToken Take(PdsTokenKind kind, string need)
    {
        PdsToken taken = _token.Kind == kind ? _token : throw Wrong(_token, $"{need} is needed");

        // What follows END is another file's business: an attached image need not be text.
        if (taken.Kind != PdsTokenKind.Word || !taken.Text.Equals("END", StringComparison.OrdinalIgnoreCase))
        {
            Advance();
        }

        return taken;
    }

    private void TakeSign(string sign, string need)
    {
        if (!_token.IsSign(sign))
        {
            throw Wrong(_token, $"{need} is needed");
        }

        Advance();
    }

    private void Advance() => _token = _tokens.Next();

    private BadInputException Wrong(PdsToken found, string need) => new(
        $"{_file}, line {found.Line}: {(found.Kind == PdsTokenKind.End ? "the label ends" : $"'{found.Text}'")}; {need}. "
            + $"Is this a whole PDS3 label?");
}
