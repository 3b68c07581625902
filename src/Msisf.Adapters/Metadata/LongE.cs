using System.Globalization;
using System.Text;

namespace Msisf.Adapters.Metadata;

/// <summary>MATLAB's longE number format, which thesis section 9.2 sets: "+2.000000000000000E+006", always 23 characters.</summary>
public static class LongE
{
    /// <summary>Characters of a number.</summary>
    public const int Length = 23;

    /// <summary>Writes a number, rounded to 16 significant digits.</summary>
    /// <param name="value">Finite; both zeros are "+0.000000000000000E+000".</param>
    /// <param name="destination">Receives <see cref="Length"/> ASCII characters.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is not finite, or there is less room.</exception>
    public static void Write(double value, Span<byte> destination)
    {
        if (!double.IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(nameof(value), value, "Only finite numbers have a place in the metadata.");
        }

        // The custom format "+0.000000000000000E+000" keeps only 15 digits; "E15" keeps 16, but has no plus sign.
        destination[0] = value < 0.0 ? (byte)'-' : (byte)'+';
        Math.Abs(value).TryFormat(destination[1..Length], out _, "E15", CultureInfo.InvariantCulture);
    }

    /// <summary>A number as text.</summary>
    /// <param name="value">Finite.</param>
    public static string ToText(double value) =>
        string.Create(Length, value, static (characters, number) =>
        {
            Span<byte> ascii = stackalloc byte[Length];
            Write(number, ascii);
            Encoding.ASCII.GetChars(ascii, characters);
        });
}
