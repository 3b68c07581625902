using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>
/// The values of the options that take several numbers (thesis appendix A): <c>{a,b,...}</c> and <c>[start:step:end]</c>. A shell may have
/// cut the text at blanks, or expanded the braces into separate words; all of these mean the same.
/// </summary>
public static class StateText
{
    private static readonly (string Unit, decimal Seconds)[] StepUnits = [("min", 60m), ("s", 1m), ("h", 3600m), ("d", 86_400m)];

    /// <summary>Reads a list of a given length.</summary>
    /// <param name="option">The option's name for messages, e.g. "--kepler-set".</param>
    /// <param name="words">What is after the option on the command line.</param>
    /// <param name="fields">The names of the numbers in their order, e.g. a, e, omega, ...</param>
    /// <returns>As many finite numbers as there are fields, in their order and in the units that were typed.</returns>
    /// <exception cref="BadInputException">Unbalanced braces, a wrong count, an empty field or one that is not a number.</exception>
    public static double[] ParseNumbers(string option, IReadOnlyList<string> words, IReadOnlyList<string> fields)
    {
        List<string> texts = SplitFields(option, words, fields);
        return [.. texts.Select((text, index) => NumberAt(option, text, index, fields[index]))];
    }

    /// <summary>Reads a time and the numbers behind it.</summary>
    /// <param name="option">The option's name for messages, e.g. "--fixed-state".</param>
    /// <param name="words">What is after the option on the command line.</param>
    /// <param name="fields">The names of the time and of the numbers in their order.</param>
    /// <returns>The time (UTC); as many finite numbers as there are fields behind it, in their order.</returns>
    /// <exception cref="BadInputException">As of <see cref="ParseNumbers"/>, or it begins with no time.</exception>
    public static (CalendarTime Time, double[] Numbers) ParseState(
        string option, IReadOnlyList<string> words, IReadOnlyList<string> fields)
    {
        List<string> texts = SplitFields(option, words, fields);
        return (
            TimeAt(option, texts[0], 0, fields[0]),
            [.. texts.Skip(1).Select((text, index) => NumberAt(option, text, index + 1, fields[index + 1]))]);
    }

    /// <summary>Reads a list of any length from 1.</summary>
    /// <param name="option">The option's name for messages, e.g. "--heights".</param>
    /// <param name="words">What is after the option on the command line.</param>
    /// <param name="field">What each number is, for messages, e.g. "M".</param>
    /// <returns>Finite numbers in their order.</returns>
    /// <exception cref="BadInputException">Unbalanced braces, no number, an empty field or one that is not a number.</exception>
    public static double[] ParseList(string option, IReadOnlyList<string> words, string field) =>
        ParseList(option, words, field, NumberAt);

    /// <summary>Reads a list of times of any length from 1.</summary>
    /// <param name="option">The option's name for messages, e.g. "--times".</param>
    /// <param name="words">What is after the option on the command line.</param>
    /// <returns>UTC, in their order.</returns>
    /// <exception cref="BadInputException">Unbalanced braces, no time, an empty field or one that is not a time.</exception>
    public static CalendarTime[] ParseTimes(string option, IReadOnlyList<string> words) =>
        ParseList(option, words, TimeText.Field, TimeAt);

    private static T[] ParseList<T>(string option, IReadOnlyList<string> words, string field, Func<string, string, int, string, T> parse)
    {
        string expected = $"{{{field}1,{field}2,...}}";
        List<string> texts = SplitList(option, words, expected);
        return texts.Count > 0
            ? [.. texts.Select((text, index) => parse(option, text, index, Invariant($"{field}{index + 1}")))]
            : throw new BadInputException($"{option}: the list is empty; {expected} is expected.");
    }

    /// <summary>Reads an interval of times, [start:step:end]: MJD, days, MJD.</summary>
    /// <param name="option">The option's name for messages, e.g. "--time-interval".</param>
    /// <param name="words">What is after the option on the command line.</param>
    /// <returns>The times; possibly none. The step is in days, or has its unit behind it: 10s, 5min, 2h, 1d.</returns>
    /// <exception cref="BadInputException">Not of this form, or the numbers do not make an interval.</exception>
    public static TimeInterval ParseInterval(string option, IReadOnlyList<string> words)
    {
        const string expected = "[start:step:end]";
        string text = Unwrapped(option, words, '[', ']', expected);
        List<string> texts = SplitInterval(text);
        if (texts.Count != 3)
        {
            string hint = text.Contains('T', StringComparison.OrdinalIgnoreCase) ? $" A time is {TimeText.ValidValues}." : string.Empty;
            throw new BadInputException(
                $"{option}: {CountOf(texts.Count)}, 3 expected: {expected} in MJD, days (or 10s, 5min, 2h), MJD; colons separate the "
                    + $"numbers.{hint}");
        }

        (string step, decimal unit) = SplitUnit(texts[1]);
        CalendarTime start = TimeAt(option, texts[0], 0, "start");
        double count = NumberAt(option, step, 1, "step");
        CalendarTime end = TimeAt(option, texts[2], 2, "end");
        try
        {
            return new TimeInterval(start, Duration.OfDecimal(count, unit), end);
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{option}: {exception.Message}", exception);
        }
    }

    /// <summary>The number of a step, and how many seconds its unit has.</summary>
    private static (string Number, decimal Seconds) SplitUnit(string step)
    {
        foreach ((string unit, decimal seconds) in StepUnits)
        {
            if (step.EndsWith(unit, StringComparison.OrdinalIgnoreCase))
            {
                return (step[..^unit.Length].TrimEnd(), seconds);
            }
        }

        return (step, 86_400m);
    }

    /// <summary>Splits at the colons that do not belong to a time of ISO 8601.</summary>
    private static List<string> SplitInterval(string text)
    {
        List<string> parts = [];
        for (int start = 0; start <= text.Length;)
        {
            int end = text.IndexOf(':', start + TimeText.LengthOfIsoTime(text, start));
            end = end < 0 ? text.Length : end;
            parts.Add(text[start..end].Trim());
            start = end + 1;
        }

        return parts;
    }

    private static List<string> SplitList(string option, IReadOnlyList<string> words, string expected)
    {
        string joined = string.Join(' ', words).Trim();
        string inner = Unwrapped(option, words, '{', '}', expected);
        if (inner.Length == 0)
        {
            return [];
        }

        // Words that the shell made of the braces have neither braces nor commas left; a stray blank inside braces is not a separator.
        bool isExpanded = inner.Length == joined.Length && !inner.Contains(',');
        return isExpanded
            ? [.. inner.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)]
            : [.. inner.Split(',', StringSplitOptions.TrimEntries)];
    }

    /// <summary>The text without its outer brackets, which may be missing as a pair.</summary>
    private static string Unwrapped(string option, IReadOnlyList<string> words, char open, char close, string expected)
    {
        string text = string.Join(' ', words).Trim();
        bool opens = text.StartsWith(open);
        bool closes = text.EndsWith(close);
        string inner = opens && closes && text.Length > 1 ? text[1..^1].Trim() : text;
        return inner.AsSpan().ContainsAny(open, close)
            ? throw new BadInputException(
                $"{option}: {NumberText.Shown(text)} has unbalanced '{open}' and '{close}'; "
                    + $"{expected} is expected, quoted so that the shell leaves it alone.")
            : inner;
    }

    private static List<string> SplitFields(string option, IReadOnlyList<string> words, IReadOnlyList<string> fields)
    {
        string expected = $"{{{string.Join(',', fields)}}}";
        List<string> texts = SplitList(option, words, expected);
        return texts.Count == fields.Count
            ? texts
            : throw new BadInputException(
                $"{option}: {CountOf(texts.Count)}, {fields.Count} expected: {expected}. "
                    + $"Commas separate the numbers, decimals take a point.");
    }

    private static double NumberAt(string option, string text, int index, string field) => NumberText.TryParse(text, out double number)
        ? number
        : throw Wrong(option, index, field, NumberText.ProblemWith(text));

    private static CalendarTime TimeAt(string option, string text, int index, string field) =>
        TimeText.TryParse(text, out CalendarTime time) ? time : throw Wrong(option, index, field, TimeText.ProblemWith(text));

    private static BadInputException Wrong(string option, int index, string field, string problem) =>
        new($"{option}, number {index + 1} ({field}): {problem}.");

    private static string CountOf(int count) => count == 1 ? "1 number" : Invariant($"{count} numbers");
}
