using System.Text.RegularExpressions;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Raster.Pds;

/// <summary>Numbers of which samples are.</summary>
public enum PixelType
{
    /// <summary>8 bits without sign.</summary>
    Unsigned8,

    /// <summary>16 bits with sign.</summary>
    Signed16,

    /// <summary>16 bits without sign.</summary>
    Unsigned16,

    /// <summary>32 bits with sign.</summary>
    Signed32,

    /// <summary>32 bits, IEEE 754.</summary>
    Real32,

    /// <summary>64 bits, IEEE 754.</summary>
    Real64,
}

/// <summary>SAMPLE_TYPE with SAMPLE_BITS of a PDS3 label: the same for all its synonyms and spellings.</summary>
/// <remarks>Planetary Data System Standards Reference 3.8, section 3.1 and appendix C.</remarks>
/// <param name="Type">Type of the numbers.</param>
/// <param name="IsBigEndian">The most significant byte comes first.</param>
internal readonly partial record struct PdsSampleType(PixelType Type, bool IsBigEndian)
{
    /// <summary>Bytes of a sample.</summary>
    public int Bytes => Type switch
    {
        PixelType.Unsigned8 => 1,
        PixelType.Signed16 or PixelType.Unsigned16 => 2,
        PixelType.Real64 => 8,
        _ => 4,
    };

    /// <summary>The type of an IMAGE object's samples; null if it is none of these.</summary>
    /// <exception cref="BadInputException">SAMPLE_TYPE or SAMPLE_BITS is missing or no word or number.</exception>
    public static PdsSampleType? Of(PdsObject image)
    {
        int bits = image.RequiredInteger("SAMPLE_BITS", 1, 64);
        image.RequiredText("SAMPLE_TYPE");
        Match name = Name().Match(image.Required("SAMPLE_TYPE").Word);
        bool isBigEndian = name.Groups["least"].Length == 0;
        PixelType? type = (name.Groups["number"].Value, bits) switch
        {
            // LROC's labels say LSB_INTEGER of 8 bits, which count from 0 to 255.
            ("INTEGER" or "UNSIGNED_INTEGER", 8) => PixelType.Unsigned8,
            ("INTEGER", 16) => PixelType.Signed16,
            ("UNSIGNED_INTEGER", 16) => PixelType.Unsigned16,
            ("INTEGER", 32) => PixelType.Signed32,
            ("REAL" or "FLOAT", 32) => PixelType.Real32,
            ("REAL" or "FLOAT", 64) => PixelType.Real64,
            _ => null,
        };
        return type is { } known ? new PdsSampleType(known, isBigEndian) : null;
    }

    /// <summary>
    /// The sample that a constant of the label means: a number, or the bits of a sample as the special values of reals are written
    /// (16#FF7FFFFB#).
    /// </summary>
    /// <returns>The number; null if the text is neither.</returns>
    public double? Constant(string text)
    {
        if (NumberText.TryParse(text, out double number))
        {
            return number;
        }

        Match radix = InRadix().Match(text);
        return !radix.Success ? null : ToNumber(radix.Groups[1].Value, radix.Groups[2].Value) is not { } bits ? null : Type switch
        {
            PixelType.Real32 => BitConverter.UInt32BitsToSingle((uint)bits),
            PixelType.Real64 => BitConverter.UInt64BitsToDouble(bits),
            PixelType.Signed16 => (short)bits,
            PixelType.Signed32 => (int)bits,
            _ => bits,
        };
    }

    private static ulong? ToNumber(string radix, string digits) => radix switch
    {
        "2" => ulong.TryParse(digits, NumberStyles.AllowBinarySpecifier, CultureInfo.InvariantCulture, out ulong bits) ? bits : null,
        "16" => ulong.TryParse(digits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out ulong bits) ? bits : null,
        _ => null,
    };

    /// <summary>Only integers of a VAX fit: its reals are not those of IEEE 754.</summary>
    [GeneratedRegex("^(?:(?:MSB|MAC|SUN|IEEE)_|(?<least>LSB|PC)_|(?<least>VAX)_(?=(?:UNSIGNED_)?INTEGER$))?(?<number>.+)$")]
    private static partial Regex Name();

    [GeneratedRegex("^(2|16)#([0-9A-Fa-f]{1,64})#$")]
    private static partial Regex InRadix();
}
