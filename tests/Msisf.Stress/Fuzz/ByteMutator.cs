using System.Text;

namespace Msisf.Stress.Fuzz;

/// <summary>Damages bytes at random, as editors, disks, transfers and people do. The same random numbers, the same damage.</summary>
internal static class ByteMutator
{
    private const int MaxDamages = 4;
    private const int MaxRepetitions = 3000;

    /// <summary>A damaged copy.</summary>
    /// <param name="content">The right content; may be empty.</param>
    /// <param name="random">Draws the damage.</param>
    public static byte[] Mutate(byte[] content, CaseRandom random)
    {
        byte[] damaged = content;
        for (int left = 1 + random.Below(MaxDamages); left > 0; left--)
        {
            damaged = Damage(damaged, random);
        }

        return damaged;
    }

    /// <summary>A damaged copy of a text.</summary>
    public static string Mutate(string text, CaseRandom random) => Encoding.UTF8.GetString(Mutate(Encoding.UTF8.GetBytes(text), random));

    private static byte[] Damage(byte[] content, CaseRandom random)
    {
        int place = random.Below(content.Length + 1);
        return random.Below(15) switch
        {
            0 or 1 => FlipBit(content, random),
            2 => Replace(content, place, 1 + random.Below(8), RandomBytes(random)),
            3 => Replace(content, place, 0, RandomBytes(random)),
            4 => Replace(content, place, 1 + random.Below(8), []),
            5 => content[..place],
            6 => content[place..],
            7 => Repeat(content, place, random),
            8 => Replace(content, place, 0, Bytes(FuzzWords.Signs, random)),
            9 or 10 => ReplaceToken(content, random, Bytes(FuzzWords.Numbers, random)),
            11 => SwapTokens(content, random),
            12 => MoveLines(content, random),
            13 => Encode(content, random),
            _ => Replace(
                content,
                place,
                0,
                [.. Enumerable.Repeat(Bytes(FuzzWords.Signs, random), 1 + random.Below(MaxRepetitions)).SelectMany(sign => sign)]),
        };
    }

    private static byte[] FlipBit(byte[] content, CaseRandom random)
    {
        byte[] flipped = [.. content];
        if (flipped.Length > 0)
        {
            flipped[random.Below(flipped.Length)] ^= (byte)(1 << random.Below(8));
        }

        return flipped;
    }

    private static byte[] Repeat(byte[] content, int place, CaseRandom random)
    {
        byte[] piece = content[place..Math.Min(content.Length, place + 1 + random.Below(64))];
        return Replace(content, place, 0, [.. Enumerable.Repeat(piece, 1 + random.Below(MaxRepetitions)).SelectMany(repeated => repeated)]);
    }

    private static byte[] ReplaceToken(byte[] content, CaseRandom random, byte[] by)
    {
        (int start, int length) = Token(content, random);
        return Replace(content, start, length, by);
    }

    private static byte[] SwapTokens(byte[] content, CaseRandom random)
    {
        (int start, int length) = Token(content, random);
        (int otherStart, int otherLength) = Token(content, random);
        byte[] other = content[otherStart..(otherStart + otherLength)];
        byte[] one = content[start..(start + length)];
        return start + length <= otherStart
            ? Replace(Replace(content, otherStart, otherLength, one), start, length, other)
            : Replace(content, start, length, other);
    }

    /// <summary>A run of letters, digits and signs of numbers around a random place.</summary>
    private static (int Start, int Length) Token(byte[] content, CaseRandom random)
    {
        bool IsOfToken(int place) => place >= 0 && place < content.Length
            && (char.IsAsciiLetterOrDigit((char)content[place]) || ".+-_".Contains((char)content[place]));
        int start = random.Below(content.Length + 1);
        int end = start;
        while (IsOfToken(start - 1))
        {
            start--;
        }

        while (IsOfToken(end))
        {
            end++;
        }

        return (start, end - start);
    }

    private static byte[] MoveLines(byte[] content, CaseRandom random)
    {
        List<byte[]> lines = [];
        for (int start = 0; start < content.Length;)
        {
            int end = Array.IndexOf(content, (byte)'\n', start);
            end = end < 0 ? content.Length : end + 1;
            lines.Add(content[start..end]);
            start = end;
        }

        if (lines.Count > 0)
        {
            byte[] line = lines[random.Below(lines.Count)];
            if (random.Unit() < 0.5)
            {
                lines.Remove(line);
            }

            lines.Insert(random.Below(lines.Count + 1), line);
        }

        return [.. lines.SelectMany(line => line)];
    }

    private static byte[] Encode(byte[] content, CaseRandom random) => random.Below(5) switch
    {
        0 => [.. Encoding.UTF8.GetPreamble(), .. content],
        1 => [.. Encoding.Unicode.GetPreamble(), .. Encoding.Convert(Encoding.Latin1, Encoding.Unicode, content)],
        2 => Encoding.Convert(Encoding.Latin1, Encoding.BigEndianUnicode, content),
        3 => Encoding.Convert(Encoding.Latin1, Encoding.UTF8, content),
        _ => [.. content.SelectMany(value => value == (byte)'\n' ? "\r\n"u8.ToArray() : [value])],
    };

    private static byte[] Replace(byte[] content, int start, int length, ReadOnlySpan<byte> by)
    {
        int end = Math.Min(content.Length, start + length);
        return [.. content.AsSpan(0, start), .. by, .. content.AsSpan(end)];
    }

    private static byte[] RandomBytes(CaseRandom random) =>
        [.. Enumerable.Range(0, 1 + random.Below(8)).Select(_ => (byte)random.Below(256))];

    private static byte[] Bytes(IReadOnlyList<string> words, CaseRandom random) => Encoding.UTF8.GetBytes(words[random.Below(words.Count)]);
}
