using System.Buffers;
using System.Text;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Input;

/// <summary>
/// Reads numbers as the thesis writes them (section 6.3.2): decimal or scientific, with a decimal point whatever the culture; a plus sign
/// is optional.
/// </summary>
public static class NumberText
{
    /// <summary>What a number may look like, for messages.</summary>
    public const string ValidValues = "decimal or scientific notation with a decimal point, e.g. -1737400.5 or +1.7374E+006";

    private const int LongestEcho = 40;

    private static readonly SearchValues<char> CharactersOfNumbers = SearchValues.Create("0123456789+-.eE");

    /// <summary>Reads one number, without anything around it. A number too small for a double becomes 0.</summary>
    /// <param name="text">The characters of the number alone.</param>
    /// <param name="value">The nearest double.</param>
    /// <returns>False if it is not a number, or too large for one: <see cref="ProblemWith"/> says why.</returns>
    public static bool TryParse(ReadOnlySpan<char> text, out double value)
    {
        const NumberStyles decimalOrScientific =
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;

        // double.TryParse alone takes "NaN", "Infinity" and trailing NUL characters, and makes infinity of 1e999.
        value = 0.0;
        return !text.ContainsAnyExcept(CharactersOfNumbers)
            && double.TryParse(text, decimalOrScientific, CultureInfo.InvariantCulture, out value)
            && double.IsFinite(value);
    }

    /// <summary>Why <see cref="TryParse"/> refuses a text, and what to write: "'1,5' has a comma; ...".</summary>
    /// <param name="text">The refused characters; shown shortened and without control characters.</param>
    public static string ProblemWith(ReadOnlySpan<char> text)
    {
        string shown = Shown(text);
        ReadOnlySpan<char> digits = text.TrimStart("+-");
        return digits switch
        {
            _ when text.IsWhiteSpace() => "a number is missing",
            _ when text.Contains('\uFFFD') => $"{shown} is not UTF-8 text; is this file binary?",
            _ when text.Contains(',') => $"{shown} has a comma; numbers have a decimal point and no thousands separators",
            _ when text.ContainsAny('\u2212', '\u2013') => $"{shown} has a typographic minus sign; write '-'",
            _ when digits.StartsWith("0x", StringComparison.OrdinalIgnoreCase) => $"{shown} is hexadecimal; write {ValidValues}",
            _ when IsNotFiniteByName(digits) => $"{shown} is not finite; a finite number is needed",
            _ when IsTooLarge(text) => $"{shown} is too large; numbers reach up to 1.797E+308",
            _ => $"{shown} is not a number; write {ValidValues}",
        };
    }

    /// <summary>A text in quotes for a message: at most 40 characters, each that can't be printed as "?".</summary>
    public static string Shown(ReadOnlySpan<char> text)
    {
        StringBuilder shown = new("'");
        foreach (char character in text[..Math.Min(text.Length, LongestEcho)])
        {
            shown.Append(char.IsControl(character) || char.IsSurrogate(character) ? '?' : character);
        }

        return shown.Append(text.Length > LongestEcho ? "...'" : "'").ToString();
    }

    private static bool IsNotFiniteByName(ReadOnlySpan<char> text) =>
        text.Equals("nan", StringComparison.OrdinalIgnoreCase)
        || text.Equals("inf", StringComparison.OrdinalIgnoreCase)
        || text.Equals("infinity", StringComparison.OrdinalIgnoreCase)
        || text.Equals("\u221E", StringComparison.Ordinal);

    private static bool IsTooLarge(ReadOnlySpan<char> text) =>
        !text.ContainsAnyExcept(CharactersOfNumbers)
        && double.TryParse(text, CultureInfo.InvariantCulture, out double value)
        && double.IsInfinity(value);
}

/// <summary>Reads and writes a noise seed: <c>N</c>, a whole number, or <c>N:STEP</c> with the number of the frame.</summary>
public static class NoiseSeedText
{
    /// <summary>What the text may look like, for messages.</summary>
    public const string ValidValues = "a whole number from 0 on, or two with a colon between them: N:STEP";

    /// <summary>Reads a seed.</summary>
    /// <param name="step">Number of the frame if the text has none.</param>
    /// <exception cref="BadInputException">It is not such a text.</exception>
    public static NoiseSeed Parse(string text, ulong step)
    {
        string[] parts = text.Split(':');
        return parts.Length <= 2 && TryParse(parts[0], out ulong number) && (parts.Length == 1 || TryParse(parts[1], out step))
            ? new NoiseSeed(number, step)
            : throw new BadInputException($"{NumberText.Shown(text)} is not a noise seed; {ValidValues}.");
    }

    /// <summary>The text of a seed with its step.</summary>
    public static string Of(NoiseSeed seed) => Invariant($"{seed.Number}:{seed.Step}");

    private static bool TryParse(string text, out ulong number) =>
        ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
