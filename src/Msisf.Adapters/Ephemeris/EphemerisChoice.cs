namespace Msisf.Adapters.Ephemeris;

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
