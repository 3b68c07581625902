using Msisf.App.Settings.Specs;
using Msisf.Core.Orbit;

namespace Msisf.App.Settings;

/// <summary>The options of thesis table 6.1: where the camera is, when, and how it points.</summary>
internal static class CameraOptions
{
    /// <summary>One state.</summary>
    public static NumberListSpec FixedState { get; } = new(
        "--fixed-state", ["MJD", "rx", "ry", "rz", "qx", "qy", "qz", "q0"],
        "One image: time (MJD, UTC), position (m, ME/PA) and orientation (quaternion)");

    /// <summary>States in a file.</summary>
    public static PathSpec BatchFile { get; } = new(
        "--batch-file", PathKind.File,
        "One image a line of the file: MJD rx ry rz qx qy qz q0; # begins a comment; - reads standard input");

    /// <summary>An orbit by its elements.</summary>
    public static NumberListSpec KeplerSet { get; } = new(
        "--kepler-set",
        ["a", "e", "omega", "Omega", "i", "M0"],
        "Kepler orbit: semi-major axis (m), eccentricity, argument of periapsis, longitude of the ascending node, inclination, "
            + "mean anomaly at the epoch (rad)")
    {
        Aliases = ["-k"],
    };

    /// <summary>An orbit by position and velocity.</summary>
    public static NumberListSpec StateVectors { get; } = new(
        "--state-vectors", ["rx", "ry", "rz", "drx", "dry", "drz"], "Orbit by position (m) and velocity (m/s) at the epoch")
    {
        Aliases = ["-s"],
    };

    /// <summary>Time of the orbit.</summary>
    public static NumberSpec Epoch { get; } = new(
        "--epoch", "MJD", "Time for which the orbit and the attitude are given (UTC)")
    {
        Aliases = ["-e"],
    };

    /// <summary>One time.</summary>
    public static NumberSpec Time { get; } = new("--time", "MJD", "Time of one image (UTC)") { Aliases = ["-t"] };

    /// <summary>Several times.</summary>
    public static NumberListSpec Times { get; } = new("--times", ["MJD"], "Times of several images (UTC)") { Aliases = ["-tt"] };

    /// <summary>Equidistant times.</summary>
    public static TextSpec TimeInterval { get; } = new(
        "--time-interval", "[start:step:end]", "Times of a series of images: from start to end (MJD, UTC) in steps of days");

    /// <summary>Orientation at the epoch.</summary>
    public static NumberListSpec Attitude { get; } = new("--attitude", ["qx", "qy", "qz", "q0"], "Orientation at the epoch (quaternion)")
    {
        Aliases = ["-a"],
        DefaultNote = "the nadir, north up",
    };

    /// <summary>Rotation of the spacecraft.</summary>
    public static NumberListSpec AttitudeTransition { get; } = new(
        "--attitude-transition", ["wx", "wy", "wz"], "Angular velocity about the spacecraft's own axes (rad/s), from the epoch on")
    {
        Aliases = ["-at"],
        DefaultNote = "{0,0,0}",
    };

    /// <summary>Frame of the orbit.</summary>
    public static ChoiceSpec<OrbitFrame> OrbitFrame { get; } = new(
        "--orbit-frame",
        [
            new Choice("moon-me", Core.Orbit.OrbitFrame.MoonMe),
            new Choice("moon-me-epoch", Core.Orbit.OrbitFrame.MoonMeEpoch),
            new Choice("j2000", Core.Orbit.OrbitFrame.J2000),
        ],
        "Frame of the orbit: ME/PA that turns with the Moon, ME/PA of the epoch held still, or J2000")
    {
        Default = Core.Orbit.OrbitFrame.MoonMe,
    };

    /// <summary>The options of this class as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new(
        "Where the camera is",
        [FixedState, BatchFile, KeplerSet, StateVectors, Epoch, Time, Times, TimeInterval, Attitude, AttitudeTransition, OrbitFrame])
    {
        Note =
            "Exactly one of the first four. An orbit (-k, -s) needs --epoch and one of --time, --times and --time-interval. "
                + "Values in braces are quoted.",
    };
}
