using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Which ephemeris engine to open, and with what.</summary>
/// <param name="KernelFiles">A meta-kernel, or kernels in load order; relative names start at the working directory.</param>
/// <param name="InstallationRoot">The folder that holds lib/native.</param>
/// <param name="CSpicePath">MSISF_CSPICE: the only library to try; null or empty to look in the usual places.</param>
public sealed record EphemerisRequest(
    EphemerisChoice Choice,
    IReadOnlyList<string> KernelFiles,
    string InstallationRoot,
    string? CSpicePath)
{
    /// <summary>The body from whose centre, and in whose frame, the Sun is given.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;
}

/// <summary>What the user asks for with --ephemeris (auto, cspice, builtin).</summary>
public enum EphemerisChoice
{
    /// <summary>CSPICE if its library loads, else the built-in reader.</summary>
    Auto,

    /// <summary>CSPICE or an error.</summary>
    CSpice,

    /// <summary>The built-in reader.</summary>
    BuiltIn,
}
