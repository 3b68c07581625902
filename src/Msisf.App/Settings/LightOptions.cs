using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;

namespace Msisf.App.Settings;

/// <summary>The options of the light and the ephemeris.</summary>
internal static class LightOptions
{
    public static FlagSpec IgnoreSun { get; } = new(
        "--ignore-sun", DecidesBytes.As(frame => frame.Settings.IgnoreSun).AndTiles(),
        "Light the scene from the camera instead of the Sun");

    public static NumberListSpec SunPosition { get; } = new(
        "--sun-position", DecidesBytes.ByStates, ["x", "y", "z"],
        "Where the Sun is (m, ME/PA), whatever the time: of a simulator with a Sun of its own. A batch file has columns for it")
    {
        DefaultNote = "where the ephemeris has it",
    };

    public static ChoiceSpec<EphemerisChoice> Ephemeris { get; } = new(
        "--ephemeris", DecidesBytes.As(frame => frame.Settings.IgnoreSun ? null : frame.Engine ?? EphemerisChoice.BuiltIn),
        [
            new Choice("cspice", EphemerisChoice.CSpice),
            new Choice("builtin", EphemerisChoice.BuiltIn),
            new Choice("auto", EphemerisChoice.Auto),
        ],
        "What computes the Sun's position")
    {
        Default = EphemerisChoice.Auto,
        DefaultNote = "auto: CSPICE if its library loads, otherwise built-in",
    };

    public static ChoiceSpec<Aberration> Aberration { get; } = new(
        "--aberration", DecidesBytes.As(frame => frame.Settings.IgnoreSun ? null : frame.Settings.Aberration).AndTiles(),
        [
            new Choice("none", Core.Ephemeris.Aberration.None),
            new Choice("lt", Core.Ephemeris.Aberration.LightTime),
            new Choice("lt+s", Core.Ephemeris.Aberration.LightTimeAndStellar),
        ],
        "Where the Sun is seen: where it is, with light time, or with stellar aberration too")
    {
        Default = Core.Ephemeris.Aberration.None,
    };

    public static PathSpec Kernels { get; } = new(
        "--kernels", DecidesBytes.ByFiles.AndTiles(), PathKind.File,
        "SPICE meta-kernel in place of the installed one, or another kernel on top of it (FK, IK, SCLK, ...); may be given several times")
    {
        TakesSeveral = true,
        DefaultNote = "kernels/msisf.tm of the installation",
    };

    public static OptionGroup Group { get; } = new("Light", [IgnoreSun, SunPosition, Aberration, Ephemeris, Kernels]);
}
