using System.Globalization;
using System.Text;

namespace Msisf.Adapters.Metadata;

/// <summary>
/// MATLAB's longE number format, which thesis section 9.2 sets: "+2.000000000000000E+006", always 23 characters; or the same with a digit
/// more, which reads back to the same double.
/// </summary>
public static class LongE
{
    /// <summary>Characters of a number of 16 digits.</summary>
    public const int Length = 23;

    /// <summary>Characters of a number with the most digits.</summary>
    public const int MaximumLength = Length + 1;

    /// <summary>Characters of a number.</summary>
    public static int LengthOf(LongEDigits digits) => digits == LongEDigits.RoundTrip ? MaximumLength : Length;

    /// <summary>Writes a number.</summary>
    /// <param name="value">Finite; both zeros are "+0.000000000000000E+000".</param>
    /// <param name="destination">Receives <see cref="LengthOf"/> ASCII characters.</param>
    /// <param name="digits">Significant digits, to which it is rounded.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is not finite, or there is less room.</exception>
    public static void Write(double value, Span<byte> destination, LongEDigits digits = LongEDigits.Thesis)
    {
        if (!double.IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(nameof(value), value, "Only finite numbers have a place in the metadata.");
        }

        // The custom format "+0.000000000000000E+000" keeps only 15 digits; "E15" keeps 16, but has no plus sign.
        destination[0] = value < 0.0 ? (byte)'-' : (byte)'+';
        string format = digits == LongEDigits.RoundTrip ? "E16" : "E15";
        Math.Abs(value).TryFormat(destination[1..LengthOf(digits)], out _, format, CultureInfo.InvariantCulture);
    }

    /// <summary>A number as text.</summary>
    /// <param name="value">Finite.</param>
    /// <param name="digits">Significant digits.</param>
    public static string ToText(double value, LongEDigits digits = LongEDigits.Thesis) =>
        string.Create(LengthOf(digits), (value, digits), static (characters, number) =>
        {
            Span<byte> ascii = stackalloc byte[characters.Length];
            Write(number.value, ascii, number.digits);
            Encoding.ASCII.GetChars(ascii, characters);
        });
}

/// <summary>Significant digits of a number in the longE format.</summary>
public enum LongEDigits
{
    /// <summary>16, as thesis section 9.2 has them; some doubles read back to a neighbour.</summary>
    Thesis,

    /// <summary>17: every double reads back as it was.</summary>
    RoundTrip,
}
