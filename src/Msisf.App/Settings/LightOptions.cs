using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;

namespace Msisf.App.Settings;

/// <summary>The options that say where the light comes from.</summary>
internal static class LightOptions
{
    /// <summary>Light from the camera.</summary>
    public static FlagSpec IgnoreSun { get; } = new("--ignore-sun", "Light the scene from the camera instead of the Sun");

    /// <summary>Ephemeris engine.</summary>
    public static ChoiceSpec<EphemerisChoice> Ephemeris { get; } = new(
        "--ephemeris",
        [("cspice", EphemerisChoice.CSpice), ("builtin", EphemerisChoice.BuiltIn), ("auto", EphemerisChoice.Auto)],
        "What computes the Sun's position")
    {
        Default = EphemerisChoice.Auto,
        DefaultNote = "auto: CSPICE if its library loads, else built-in",
    };

    /// <summary>Corrections for the time that light takes.</summary>
    public static ChoiceSpec<Aberration> Aberration { get; } = new(
        "--aberration",
        [("none", Core.Ephemeris.Aberration.None), ("lt", Core.Ephemeris.Aberration.LightTime), (
            "lt+s", Core.Ephemeris.Aberration.LightTimeAndStellar)],
        "Where the Sun is seen: where it is, with light time, or with stellar aberration too")
    {
        Default = Core.Ephemeris.Aberration.None,
    };

    /// <summary>Meta-kernel.</summary>
    public static PathSpec Kernels { get; } = new(
        "--kernels", PathKind.File, "SPICE meta-kernel")
    {
        DefaultNote = "kernels/msisf.tm of the installation",
    };

    /// <summary>All of them.</summary>
    public static OptionGroup Group { get; } = new("Light", [IgnoreSun, Aberration, Ephemeris, Kernels]);
}
