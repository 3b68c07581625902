namespace Msisf.Adapters.Ephemeris;

/// <summary>The dates that follow @ in text kernels, in every form that SPICE reads without a blank.</summary>
/// <remarks>
/// NAIF, Time Required Reading, "Input String Conventions". Numbers get their meaning from their order, as the tables below have it: year
/// Y, month m, day D, day of year y, hours H, minutes M, seconds S. Like SPICE, it goes on counting past the end of a month, a day or an
/// hour (1972-FEB-30 is 1 March), and rounds a day with decimals. A test compares random dates with CSPICE's.
/// </remarks>
internal static class KernelDate
{
    /// <summary>JD of 2000-01-01T12:00:00.</summary>
    private const double JulianDateOfJ2000 = 2451545.0;

    private const double SecondsPerDay = 86400.0;

    /// <summary>Whole numbers from here on are years.</summary>
    private const double FirstPlainYear = 1000.0;

    /// <summary>The first of the hundred years that a year of two digits may mean.</summary>
    private const int FirstYearOfTwoDigits = 1969;

    /// <summary>Years after which the calendar begins anew, and their days.</summary>
    private const int YearsOfCycle = 400;
    private const int DaysOfCycle = 146_097;

    /// <summary>Hours, minutes and seconds that colons join, the longest first; of four numbers the first is the day.</summary>
    private static readonly string[] Chains = ["i:i:i:n", "i:i:i:i", "i:i:n", "i:i:i", "i:n", "i:i"];

    /// <summary>
    /// What dates look like. Y: a number from 1000 on; i: one below; n: one with decimals; m: the name of a month; T: numbers joined by
    /// colons; d: // or ::; t: the letter T of ISO 8601.
    /// </summary>
    private static readonly Dictionary<string, string> Plain = Expanded(
        [
            ("Y-i-it", "Y-m-Dt"), ("i-i-it", "Y-m-Dt"), ("Y-it", "Y-yt"), ("i-it", "Y-yt"), ("Yii", "YmD"), ("iiY", "mDY"),
            ("iim", "YDm"), ("imi", "YmD"), ("mii", "mDY"), ("Yim", "YDm"), ("Ymi", "YmD"), ("imY", "DmY"), ("miY", "mDY"),
        ],
        ("", ""), ("T", "T"), ("i", "H"), ("n", "H"))
        .Concat(Expanded(
            [("Yii", "YmD"), ("iim", "YDm"), ("imi", "YmD"), ("mii", "mDY")],
            ("ii", "HM"), ("in", "HM"), ("iii", "HMS"), ("iin", "HMS")))
        .Concat(Expanded(
            [
                ("Yin", "YmD"), ("Ynm", "YDm"), ("Ymn", "YmD"), ("inY", "mDY"), ("inm", "YDm"), ("imn", "YmD"), ("mnY", "mDY"),
                ("mni", "mDY"), ("nmY", "DmY"), ("i-i/T", "Y-y/T"), ("Ti/i/i", "Tm/D/Y"), ("Ti/i/Y", "Tm/D/Y"), ("Ti-i-Y", "Tm-D-Y"),
            ],
            ("", "")))
        .Concat(Expanded(
            [("iid", "Yyd"), ("i/i/i", "m/D/Y"), ("i/i/Y", "m/D/Y"), ("Y-i/", "Y-y/"), ("i-Y/", "y-Y/")], ("", ""), ("T", "T")))
        .ToDictionary();

    /// <summary>What is tried last, when colons may separate any parts.</summary>
    private static readonly Dictionary<string, string> Loose = Expanded(
        [
            ("miY", "mDY"), ("Yim", "YDm"), ("imY", "DmY"), ("Ymi", "YmD"), ("Yid", "Yyd"), ("iYd", "yYd"), ("Ydi", "Ydy"),
        ],
        ("", ""), ("T", "T"))
        .Concat(Expanded(
            [
                ("miTY", "mDTY"), ("YTim", "YTDm"), ("TYim", "TYDm"), ("TmiY", "TmDY"), ("TYmi", "TYmD"), ("YTmi", "YTmD"),
                ("TimY", "TDmY"), ("imTY", "DmTY"), ("TYid", "TYyd"), ("TiYd", "TyYd"), ("TYdi", "TYdy"), ("YmDT", "YmDT"),
                ("YDTm", "YDTm"), ("mYDT", "mYDT"), ("mDTY", "mDTY"), ("DTYm", "DTYm"), ("DTmY", "DTmY"),
            ],
            ("", "")))
        .ToDictionary();

    /// <summary>Forms of dates, for messages.</summary>
    public const string ValidValues = "@1972-JAN-1, @1972-JAN-1-12:00:00, @1972-01-01T12:00:00, @1972-001//12:00, @1/31/1972, @2441317.5JD";

    /// <summary>Reads a date.</summary>
    /// <param name="text">What is behind @.</param>
    /// <param name="secondsPastJ2000">Seconds past 2000-01-01T12:00:00, each day with 86 400 s.</param>
    /// <returns>False for what SPICE does not read.</returns>
    public static bool TryParse(string text, out double secondsPastJ2000)
    {
        double? value = KernelDateToken.Cut(text.ToUpperInvariant()) is { } tokens ? Value(tokens) : null;
        secondsPastJ2000 = value ?? 0.0;
        return value is not null;
    }

    private static double? Value(List<KernelDateToken> tokens)
    {
        RemoveFirst(tokens, "m.", 1);
        RemoveFirst(tokens, "w.", 1);
        JoinDecimals(tokens);
        if (tokens.RemoveAll(token => token.Kind == 'j') > 0)
        {
            return Kinds(tokens) is "i" or "n" or "-i" or "-n"
                ? ((tokens.Count > 1 ? -1.0 : 1.0) * tokens[^1].Value - JulianDateOfJ2000) * SecondsPerDay
                : null;
        }

        int ofEra = Kinds(tokens).IndexOf("ie", StringComparison.Ordinal);
        tokens = [.. tokens.Select((token, i) =>
            token.Kind == 'i' && (token.Value >= FirstPlainYear || i == ofEra) ? token with { Kind = 'Y' } : token)];
        double? era = RemoveFirst(tokens, "e", 0)?.Value;
        RemoveFirst(tokens, "w", 0);
        if (era is not null && tokens.Exists(token => token.Kind == 't'))
        {
            return null; // only ISO's dates have a T, and they have no era
        }

        return Meaning(tokens) is { } found ? Seconds(found.Tokens, found.Meaning, era) : null;
    }

    /// <summary>What each token means: first with its separators, then without dashes, then without slashes, then without colons.</summary>
    private static (List<KernelDateToken> Tokens, string Meaning)? Meaning(List<KernelDateToken> tokens)
    {
        if (Look(tokens, string.Empty) is { } whole)
        {
            return whole;
        }

        string kinds = Kinds(tokens);
        if (kinds.Length == 0 || kinds.Contains('t') || "-/:.".Contains(kinds[0]) || "-/:.".Contains(kinds[^1])
            || kinds.Zip(kinds.Skip(1)).Any(pair => "-/:.d".Contains(pair.First) && "-/:.d".Contains(pair.Second)))
        {
            return null;
        }

        if ((Look(tokens, "-") ?? Look(tokens, "-/")) is { } found)
        {
            return found;
        }

        List<KernelDateToken> loose = Folded([.. tokens.Where(token => token.Kind is not ('-' or '/'))]);
        loose.RemoveAll(token => token.Kind == ':');
        kinds = Kinds(loose);
        return Loose.TryGetValue(kinds, out string? meaning) ? (loose, meaning)
            : kinds == "Tiim" && loose[0].Time!.Length == 3 ? (loose, "TYDm")
            : null;
    }

    private static (List<KernelDateToken> Tokens, string Meaning)? Look(List<KernelDateToken> tokens, string without)
    {
        List<KernelDateToken> folded = Folded([.. tokens.Where(token => !without.Contains(token.Kind, StringComparison.Ordinal))]);
        return Plain.TryGetValue(Kinds(folded), out string? meaning) ? (folded, meaning) : null;
    }

    /// <summary>Numbers joined by colons become one token.</summary>
    private static List<KernelDateToken> Folded(List<KernelDateToken> tokens)
    {
        string kinds = Kinds(tokens);
        foreach (string chain in Chains)
        {
            int start = kinds.LastIndexOf(chain, StringComparison.Ordinal);
            if (start >= 0)
            {
                double[] numbers = [.. tokens.GetRange(start, chain.Length).Where(token => token.Kind != ':').Select(token => token.Value)];
                return
                [
                    .. tokens[..start], .. numbers.Length == 4 ? [new KernelDateToken('D', numbers[0])] : Array.Empty<KernelDateToken>(),
                    new KernelDateToken('T', 0.0, numbers[^Math.Min(3, numbers.Length)..]), .. tokens[(start + chain.Length)..],
                ];
            }
        }

        return tokens;
    }

    private static double Seconds(List<KernelDateToken> tokens, string meaning, double? era)
    {
        double Number(char letter, double missing) =>
            meaning.IndexOf(letter, StringComparison.Ordinal) is >= 0 and int index ? tokens[index].Value : missing;

        double year = Number('Y', 0.0);
        int calendarYear = (int)(era is null && year < 100.0
            ? FirstYearOfTwoDigits + ((year - FirstYearOfTwoDigits + 2000.0) % 100.0)
            : era == -1.0 ? 1.0 - year : year);
        double day = Number('D', 1.0);
        double days = Days(calendarYear, (int)Number('m', 1.0)) + Math.Round(Number('y', day), MidpointRounding.AwayFromZero);
        double[] time = tokens.Find(token => token.Kind == 'T')?.Time
            ?? [Number('H', 0.0), Number('M', 0.0), Number('S', 0.0)];
        double seconds = time.Zip([3600.0, 60.0, 1.0], (number, unit) => number * unit).Sum();
        return (SecondsPerDay * days) - (0.5 * SecondsPerDay) + seconds;
    }

    /// <summary>Days from 2000-01-01 to the day before a month of the Gregorian calendar, by whole divisions that cut off.</summary>
    /// <remarks>H. F. Fliegel and T. C. Van Flandern, CACM 11 (1968); months above 12 follow the formula, as in SPICE.</remarks>
    private static double Days(int year, int month)
    {
        if (year < 1)
        {
            int cycles = (YearsOfCycle - year) / YearsOfCycle;
            return Days(year + (YearsOfCycle * cycles), month) - ((double)DaysOfCycle * cycles);
        }

        long y = year;
        return (367 * y) - (7 * (y + ((month + 9) / 12)) / 4) - (3 * (((y + ((month - 9) / 7)) / 100) + 1) / 4) + (275L * month / 9)
            - 730_516;
    }

    /// <summary>Joins the last number with a decimal point to what is behind it.</summary>
    private static void JoinDecimals(List<KernelDateToken> tokens)
    {
        string kinds = Kinds(tokens);
        int start = kinds.LastIndexOf("i.i", StringComparison.Ordinal);
        int count = 3;
        if (start < 0)
        {
            (start, count) = (kinds.LastIndexOf("i.", StringComparison.Ordinal), 2);
        }

        if (start >= 0)
        {
            string digits = string.Concat(tokens.GetRange(start, count).Select(token => token.Text));
            tokens.RemoveRange(start, count);
            tokens.Insert(
                start, new KernelDateToken('n', double.Parse(digits, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture)));
        }
    }

    private static KernelDateToken? RemoveFirst(List<KernelDateToken> tokens, string kinds, int offset)
    {
        int index = Kinds(tokens).IndexOf(kinds, StringComparison.Ordinal);
        if (index < 0)
        {
            return null;
        }

        KernelDateToken removed = tokens[index + offset];
        tokens.RemoveAt(index + offset);
        return removed;
    }

    private static string Kinds(List<KernelDateToken> tokens) => string.Concat(tokens.Select(token => token.Kind));

    private static IEnumerable<KeyValuePair<string, string>> Expanded(
        (string Kinds, string Meaning)[] dates, params (string Kinds, string Meaning)[] times) =>
        from date in dates
        from time in times
        select KeyValuePair.Create(date.Kinds + time.Kinds, date.Meaning + time.Meaning);
}
