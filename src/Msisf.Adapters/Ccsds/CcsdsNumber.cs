using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ccsds;

/// <summary>Reads the numbers of CCSDS files.</summary>
internal static class CcsdsNumber
{
    /// <summary>Reads a number; the D of Fortran's exponents is read as E, and noted.</summary>
    /// <param name="text">Its characters alone.</param>
    /// <param name="place">Where it stands.</param>
    public static double Parse(ReadOnlySpan<char> text, CcsdsPlace place)
    {
        if (NumberText.TryParse(text, out double number))
        {
            return number;
        }

        if (text.IndexOfAny('D', 'd') is > 0 and int exponent
            && NumberText.TryParse($"{text[..exponent]}E{text[(exponent + 1)..]}", out number))
        {
            place.Note("Numbers have Fortran's D for the exponent; it is read as E.");
            return number;
        }

        throw place.Error($"{NumberText.ProblemWith(text)}.");
    }
}
