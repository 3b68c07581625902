namespace Msisf.Adapters.Ephemeris;

/// <summary>A part of a date in a text kernel.</summary>
/// <param name="Kind">As in the tables of <see cref="KernelDate"/>; and e: an era, w: a weekday, j: JD, and separators.</param>
/// <param name="Value">Its number; of a month from 1, of an era 1 or -1.</param>
/// <param name="Time">Time of day (T): hours, minutes and perhaps seconds.</param>
/// <param name="Text">The digits of a number.</param>
internal sealed record KernelDateToken(char Kind, double Value, double[]? Time = null, string Text = "")
{
    private static readonly string[] Months =
    [
        "JANUARY", "FEBRUARY", "MARCH", "APRIL", "MAY", "JUNE", "JULY", "AUGUST", "SEPTEMBER", "OCTOBER", "NOVEMBER", "DECEMBER",
    ];

    private static readonly string[] Weekdays = ["SUNDAY", "MONDAY", "TUESDAY", "WEDNESDAY", "THURSDAY", "FRIDAY", "SATURDAY"];

    private static readonly string[] Eras = ["A.D.", "B.C.", "AD", "BC"];

    /// <summary>Cuts a date into numbers, names and separators; null if something is none of them.</summary>
    /// <param name="text">In capitals.</param>
    public static List<KernelDateToken>? Cut(string text)
    {
        List<KernelDateToken> tokens = [];
        for (int position = 0; position < text.Length;)
        {
            if (Next(text, position, tokens.Exists(token => token.Kind == 't')) is not { } next)
            {
                return null;
            }

            position += next.Length;
            if (next.Token is { } token)
            {
                tokens.Add(token);
            }
        }

        return tokens;
    }

    private static (KernelDateToken? Token, int Length)? Next(string text, int position, bool isIso)
    {
        ReadOnlySpan<char> rest = text.AsSpan(position);
        int digits = rest.IndexOfAnyExceptInRange('0', '9') is >= 0 and int end ? end : rest.Length;
        if (digits > 0)
        {
            double value = double.Parse(rest[..digits], NumberStyles.None, CultureInfo.InvariantCulture);
            return value <= int.MaxValue ? (new KernelDateToken('i', value, Text: rest[..digits].ToString()), digits) : null;
        }

        if (rest.StartsWith("//", StringComparison.Ordinal) || rest.StartsWith("::", StringComparison.Ordinal))
        {
            return (new KernelDateToken('d', 0.0), 2);
        }

        if ("-/:.".Contains(rest[0]))
        {
            return (new KernelDateToken(rest[0], 0.0, Text: "."), 1);
        }

        foreach (string era in Eras)
        {
            if (rest.StartsWith(era, StringComparison.Ordinal))
            {
                return (new KernelDateToken('e', era[0] == 'A' ? 1.0 : -1.0), era.Length);
            }
        }

        if (rest.StartsWith("JD", StringComparison.Ordinal))
        {
            return (new KernelDateToken('j', 0.0), 2);
        }

        return Name(rest, Months, 'm') ?? Name(rest, Weekdays, 'w')
            ?? (rest[0] == 'T' ? (new KernelDateToken('t', 0.0), 1)
                : isIso && rest is "Z" ? (null, 1)
                : null);
    }

    /// <summary>A name by its first three letters or more.</summary>
    private static (KernelDateToken? Token, int Length)? Name(ReadOnlySpan<char> text, string[] names, char kind)
    {
        for (int i = 0; i < names.Length; i++)
        {
            int length = text.CommonPrefixLength(names[i]);
            if (length >= 3)
            {
                return (new KernelDateToken(kind, i + 1.0), length);
            }
        }

        return null;
    }
}
