using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Changes values in the cards of a FITS header that is in memory.</summary>
internal static class FitsCards
{
    private const int CardLength = 80;

    /// <summary>Column of a value that is a text, behind its apostrophe.</summary>
    private const int TextColumn = 11;

    /// <summary>First column of a whole number, and one past its last one.</summary>
    private const int NumberColumn = 10;

    private const int NumberEnd = 30;

    /// <summary>Changes a whole number.</summary>
    /// <exception cref="ExternalPartException">The header does not have it.</exception>
    public static void SetNumber(Span<byte> header, string key, long value)
    {
        string text = value.ToString(CultureInfo.InvariantCulture).PadLeft(NumberEnd - NumberColumn);
        Encoding.ASCII.GetBytes(text, CardOf(header, key)[NumberColumn..NumberEnd]);
    }

    /// <summary>Changes a text into another one of the same length.</summary>
    /// <exception cref="ExternalPartException">The header does not have it.</exception>
    public static void SetText(Span<byte> header, string key, ReadOnlySpan<byte> text) => text.CopyTo(CardOf(header, key)[TextColumn..]);

    private static Span<byte> CardOf(Span<byte> header, string key)
    {
        Span<byte> name = stackalloc byte[NumberColumn];
        Encoding.ASCII.GetBytes($"{key,-8}= ", name);
        for (int start = 0; start < header.Length; start += CardLength)
        {
            if (header.Slice(start, CardLength).StartsWith(name))
            {
                return header.Slice(start, CardLength);
            }
        }

        throw new ExternalPartException($"CFITSIO has made a header without {key}.");
    }
}
