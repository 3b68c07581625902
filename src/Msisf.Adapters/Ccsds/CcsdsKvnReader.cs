using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ccsds;

/// <summary>Reads the form of lines (KVN).</summary>
/// <param name="message">Takes what is read.</param>
internal sealed class CcsdsKvnReader(CcsdsMessage message)
{
    private const int MostNumbers = 16;

    private readonly CcsdsPlace _place = message.Place;
    private Part _part;
    private bool _hasBlock;

    private enum Part
    {
        Header,
        Metadata,
        Data,
        Covariance,
    }

    /// <summary>Reads a file to its end.</summary>
    public void Read(TextReader reader)
    {
        BoundedLineReader lines = new(reader, _place.FileName);
        while (lines.TryRead(out ReadOnlySpan<char> line))
        {
            _place.Line = lines.LineNumber;
            Take(line);
        }

        if (_part == Part.Metadata)
        {
            throw _place.Error("the file ends within the keywords of a block. It is cut off; get it anew.");
        }

        if (!_hasBlock)
        {
            throw _place.Error($"no block in the file. An {message.Kind} has META_START, keywords, META_STOP, and lines of numbers.");
        }

        message.EndBlock();
    }

    private void Take(ReadOnlySpan<char> line)
    {
        if (line.Contains('\t'))
        {
            _place.Note("TABs are where the standard has blanks; other programs may refuse the file.");
        }

        ReadOnlySpan<char> content = line.Trim();
        if (content.IsEmpty
            || (content.StartsWith("COMMENT", StringComparison.Ordinal) && (content.Length == 7 || content[7] is ' ' or '\t')))
        {
            return;
        }

        if (!char.IsAsciiDigit(content[0]) && content[0] is not ('-' or '+' or '.') && !content.Contains('='))
        {
            TakeMark(content.ToString());
            return;
        }

        int equals = content.IndexOf('=');
        if (equals >= 0)
        {
            TakeKeyword(content[..equals].Trim().ToString(), content[(equals + 1)..].Trim().ToString());
        }
        else if (_part != Part.Covariance)
        {
            TakeData(content);
        }
    }

    private void TakeMark(string mark)
    {
        switch (mark)
        {
            case "META_START" when _part is Part.Header or Part.Data:
                BeginBlock();
                break;
            case "META_STOP" when _part == Part.Metadata:
                BeginData();
                break;
            case "COVARIANCE_START" when _part == Part.Data:
                _part = Part.Covariance;
                break;
            case "COVARIANCE_STOP" when _part == Part.Covariance:
                _part = Part.Data;
                break;
            case "DATA_START" or "DATA_STOP" when _part == Part.Data:
                break;
            case "META_START" or "META_STOP" or "COVARIANCE_START" or "COVARIANCE_STOP" or "DATA_START" or "DATA_STOP":
                throw _place.Error($"{mark} does not belong here. A block is META_START, keywords, META_STOP, lines of numbers.");
            default:
                throw _place.Error($"{NumberText.Shown(mark)} is neither 'keyword = value' nor a line of numbers.");
        }
    }

    private void TakeKeyword(string key, string value)
    {
        if (key.Contains(' '))
        {
            throw _place.Error($"{NumberText.Shown(key)} is not a keyword.");
        }

        switch (_part)
        {
            case Part.Covariance:
                break;
            case Part.Data when message.IsKeyword(key):
                throw _place.Error($"{key} is among the lines of numbers. A new block begins with META_START.");
            case Part.Data:
                throw _place.Error($"{NumberText.Shown(key)} is among the lines of numbers. Remove it.");
            case Part.Header when !message.IsKeyword(key):
                message.TakeHeader(key, value);
                break;
            case Part.Header:
                _place.Note("META_START is missing above the keywords of the block.");
                BeginBlock();
                message.TakeMetadata(key, value);
                break;
            default:
                message.TakeMetadata(key, value);
                break;
        }
    }

    private void BeginBlock()
    {
        if (_hasBlock)
        {
            message.EndBlock();
        }

        message.BeginBlock();
        (_part, _hasBlock) = (Part.Metadata, true);
    }

    private void BeginData()
    {
        message.BeginData();
        _part = Part.Data;
    }

    private void TakeData(ReadOnlySpan<char> content)
    {
        if (_part == Part.Header)
        {
            throw _place.Error($"a line of numbers is above the first block. The first line is {message.VersionKeyword} = 2.0.");
        }

        if (_part == Part.Metadata)
        {
            _place.Note("META_STOP is missing below the keywords of the block.");
            BeginData();
        }

        int end = EndOfWord(content);
        ReadOnlySpan<char> epoch = content[..end];
        Span<double> numbers = stackalloc double[MostNumbers];
        int count = 0;
        for (ReadOnlySpan<char> rest = content[end..].TrimStart(); !rest.IsEmpty; rest = rest[end..].TrimStart())
        {
            end = EndOfWord(rest);
            if (count == MostNumbers)
            {
                throw _place.Error(Invariant($"more than {MostNumbers} numbers behind the time."));
            }

            numbers[count++] = _place.Number(rest[..end]);
        }

        message.TakeData(epoch, numbers[..count], areNamed: false);
    }

    private static int EndOfWord(ReadOnlySpan<char> text)
    {
        int end = text.IndexOfAny(' ', '\t');
        return end < 0 ? text.Length : end;
    }
}
