using System.Text;

namespace Msisf.Adapters.Metadata;

/// <summary>
/// MATLAB's longE number format, which thesis section 9.2 sets: "+2.000000000000000E+006", always 23 characters; or the shortest text that
/// reads back to the same double.
/// </summary>
public static class LongE
{
    /// <summary>Characters of a number of 16 digits.</summary>
    public const int Length = 23;

    /// <summary>Characters of the longest number: "-2.2250738585072014E-308".</summary>
    public const int MaximumLength = Length + 1;

    /// <summary>Writes a number.</summary>
    /// <param name="value">Finite; both zeros have no minus sign.</param>
    /// <param name="destination">Receives the ASCII characters.</param>
    /// <param name="digits">Significant digits, to which it is rounded.</param>
    /// <returns>How many characters there are, <see cref="MaximumLength"/> at most.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The number is not finite, or there is less room.</exception>
    public static int Write(double value, Span<byte> destination, LongEDigits digits = LongEDigits.Thesis)
    {
        if (!double.IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(nameof(value), value, "Only finite numbers have a place in the metadata.");
        }

        if (digits == LongEDigits.RoundTrip)
        {
            return (value + 0.0).TryFormat(destination, out int written, default, CultureInfo.InvariantCulture) // -0 + 0 is 0
                ? written
                : throw new ArgumentOutOfRangeException(nameof(destination), destination.Length, "The number is longer.");
        }

        // The custom format "+0.000000000000000E+000" keeps only 15 digits; "E15" keeps 16, but has no plus sign.
        destination[0] = value < 0.0 ? (byte)'-' : (byte)'+';
        Math.Abs(value).TryFormat(destination[1..Length], out _, "E15", CultureInfo.InvariantCulture);
        return Length;
    }

    /// <summary>The number that a meta file's text of a number reads back to.</summary>
    /// <param name="value">Finite.</param>
    public static double Round(double value)
    {
        Span<byte> ascii = stackalloc byte[MaximumLength];
        return double.Parse(ascii[..Write(value, ascii)], NumberStyles.Float, CultureInfo.InvariantCulture);
    }

    /// <summary>A number as text.</summary>
    /// <param name="value">Finite.</param>
    /// <param name="digits">Significant digits.</param>
    public static string ToText(double value, LongEDigits digits = LongEDigits.Thesis)
    {
        Span<byte> ascii = stackalloc byte[MaximumLength];
        return Encoding.ASCII.GetString(ascii[..Write(value, ascii, digits)]);
    }
}

/// <summary>Significant digits of a number.</summary>
public enum LongEDigits
{
    /// <summary>16, as thesis section 9.2 has them; some doubles read back to a neighbour.</summary>
    Thesis,

    /// <summary>As few as read back to the same double.</summary>
    RoundTrip,
}
