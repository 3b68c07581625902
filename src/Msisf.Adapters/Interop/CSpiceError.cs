using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Turns CSPICE's error state into exceptions. Call it under <see cref="CSpice"/>'s lock.</summary>
internal static class CSpiceError
{
    /// <summary>SPICE's longest message, with the end mark (SPICE_ERROR_LMSGLN).</summary>
    private const int MessageLength = 1841;

    /// <summary>Throws if the last call failed, and makes CSPICE usable again.</summary>
    /// <param name="argument">What it was called with: a text, a time, or TDB seconds past J2000.</param>
    /// <exception cref="SpiceException">With SPICE's own short and long text.</exception>
    public static void ThrowIfFailed<T>(string function, T argument)
    {
        if (CSpiceNative.failed_c() == 0)
        {
            return;
        }

        string what = argument switch
        {
            double ephemerisSeconds => Invariant($"{ephemerisSeconds:R} s past J2000"),
            _ => $"{argument}",
        };
        string said = $"{Message("SHORT")}: {Message("LONG")}";
        CSpiceNative.reset_c();
        throw new SpiceException($"CSPICE failed in {function} ({what}): {said}");
    }

    private static string Message(string option)
    {
        Span<byte> text = stackalloc byte[MessageLength];
        text.Clear();
        CSpiceNative.getmsg_c(option, MessageLength, ref text[0]);
        int end = text.IndexOf((byte)0);
        return Encoding.UTF8.GetString(end < 0 ? text : text[..end]).Trim();
    }
}
