using System.Text;
using Msisf.Core.Time;

namespace Msisf.Adapters.Interop;

/// <summary>Turns CSPICE's error state into exceptions. Call it under <see cref="CSpice"/>'s lock.</summary>
internal static class CSpiceError
{
    /// <summary>SPICE's longest message, with the end mark (SPICE_ERROR_LMSGLN).</summary>
    private const int MessageLength = 1841;

    /// <summary>Throws if the last call failed, and makes CSPICE usable again.</summary>
    /// <param name="time">What it was asked for.</param>
    /// <exception cref="SpiceException">With SPICE's own short and long text.</exception>
    public static void ThrowIfFailed(string function, ModifiedJulianDate time)
    {
        if (CSpiceNative.failed_c() != 0)
        {
            throw Take(function, Invariant($"{time.ToIsoUtc()}, MJD {time.Days:R}"));
        }
    }

    /// <summary>Throws if the last call failed, and makes CSPICE usable again.</summary>
    /// <param name="ephemerisSeconds">The time that it was asked for: TDB seconds past J2000.</param>
    /// <exception cref="SpiceException">With SPICE's own short and long text.</exception>
    public static void ThrowIfFailed(string function, double ephemerisSeconds)
    {
        if (CSpiceNative.failed_c() != 0)
        {
            throw Take(function, Invariant($"{ephemerisSeconds:R} s past J2000"));
        }
    }

    /// <summary>Throws if the last call failed, and makes CSPICE usable again.</summary>
    /// <param name="argument">What it was called with.</param>
    /// <exception cref="SpiceException">With SPICE's own short and long text.</exception>
    public static void ThrowIfFailed(string function, string argument)
    {
        if (CSpiceNative.failed_c() != 0)
        {
            throw Take(function, argument);
        }
    }

    private static SpiceException Take(string function, string argument)
    {
        string shortText = Message("SHORT");
        string longText = Message("LONG");
        CSpiceNative.reset_c();
        return new SpiceException($"CSPICE failed in {function} ({argument}): {shortText}: {longText}");
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
