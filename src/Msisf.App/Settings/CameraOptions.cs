using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>The options of thesis table 6.1: where the camera is, when, and how it points.</summary>
internal static class CameraOptions
{
    public static NumberListSpec FixedState { get; } = new(
        "--fixed-state", DecidesBytes.ByStates, ["MJD", "rx", "ry", "rz", "qx", "qy", "qz", "q0"],
        "One image: time (MJD or ISO 8601, UTC), position (m, ME/PA) and orientation (quaternion)");

    public static PathSpec BatchFile { get; } = new(
        "--batch-file", DecidesBytes.ByStatesOfRun, PathKind.File,
        "One image a line of the file: MJD rx ry rz qx qy qz q0, or the columns that its first line names (time,lat,lon,height,...); "
            + "# begins a comment; - reads standard input");

    public static NumberListSpec KeplerSet { get; } = new(
        "--kepler-set", DecidesBytes.ByStates,
        ["a", "e", "omega", "Omega", "i", "M0"],
        "Kepler orbit: semi-major axis (m), eccentricity, argument of periapsis, longitude of the ascending node, inclination, "
            + "mean anomaly at the epoch (rad)")
    {
        Aliases = ["-k"],
    };

    public static NumberListSpec StateVectors { get; } = new(
        "--state-vectors", DecidesBytes.ByStates,
        ["rx", "ry", "rz", "drx", "dry", "drz"], "Orbit by position (m) and velocity (m/s) at the epoch")
    {
        Aliases = ["-s"],
    };

    public static TimeSpec Epoch { get; } = new(
        "--epoch", DecidesBytes.ByStates,
        "Time for which the orbit and the attitude are given; of a batch file the one from which its seconds count, and whose axes "
            + "--batch-frame moon-me-epoch has (UTC)")
    {
        Aliases = ["-e"],
    };

    public static TimeSpec Time { get; } = new("--time", DecidesBytes.ByStates, "Time of one image (UTC)") { Aliases = ["-t"] };

    public static NumberListSpec Times { get; } = new(
        "--times", DecidesBytes.ByStatesOfRun, ["MJD"], "Times of several images (UTC)")
    { Aliases = ["-tt"] };

    public static TextSpec TimeInterval { get; } = new(
        "--time-interval", DecidesBytes.ByStatesOfRun, "[start:step:end]",
        "Times of a series of images: from start to end (UTC) in steps of days, or as in 10s, 5min, 2h; the brackets may be left out");

    public static NumberListSpec Attitude { get; } = new(
        "--attitude", DecidesBytes.ByStates, ["qx", "qy", "qz", "q0"], "Orientation at the epoch (quaternion)")
    {
        Aliases = ["-a"],
        DefaultNote = "the nadir, north up",
    };

    public static NumberListSpec AttitudeTransition { get; } = new(
        "--attitude-transition", DecidesBytes.ByStates,
        ["wx", "wy", "wz"], "Angular velocity about the spacecraft's own axes (rad/s), from the epoch on")
    {
        Aliases = ["-at"],
        DefaultNote = "{0,0,0}",
    };

    public static ChoiceSpec<OrbitFrame> OrbitFrame { get; } = new(
        "--orbit-frame", DecidesBytes.ByStates,
        [
            new Choice("moon-me", Core.Orbit.OrbitFrame.MoonMe),
            new Choice("moon-me-epoch", Core.Orbit.OrbitFrame.MoonMeEpoch),
            new Choice("j2000", Core.Orbit.OrbitFrame.J2000),
        ],
        "Frame of the orbit: ME/PA that turns with the Moon, ME/PA of the epoch held still, or J2000")
    {
        Default = Core.Orbit.OrbitFrame.MoonMe,
    };

    public static ChoiceSpec<AttitudeFrame> AttitudeFrame { get; } = new(
        "--attitude-frame", DecidesBytes.ByStates,
        [
            ("moon-me", Core.Attitude.AttitudeFrame.MoonMe), ("moon-me-epoch", Core.Attitude.AttitudeFrame.MoonMeEpoch),
            ("j2000", Core.Attitude.AttitudeFrame.J2000), ("lvlh", Core.Attitude.AttitudeFrame.Lvlh),
        ],
        "Axes of --attitude and its transition, whatever --orbit-frame is: ME/PA that turns with the Moon, ME/PA of the epoch held still, "
            + "J2000, or LVLH of the orbit (x forward, y against the angular momentum, z down)")
    {
        Default = Core.Attitude.AttitudeFrame.MoonMe,
    };

    public static FlagSpec Normalize { get; } = new(
        "--normalize", DecidesBytes.ByStates,
        "Take quaternions and matrices of few decimals (2 or more), and make them rotations; otherwise their length must "
            + "be 1 within 1e-6");

    public static NumberListSpec Motion { get; } = new(
        "--motion", DecidesBytes.ByStates,
        CameraMotion.NumberNames,
        "Velocity over the Moon (m/s, ME/PA) and angular velocity about the camera's axes (rad/s, relative to ME/PA) during the exposure. "
            + "For a camera file that has a shutter, and no orbit");

    public static OptionGroup Group { get; } = new(
        "Where the camera is",
        [
            FixedState, BatchFile, KeplerSet, StateVectors, PointingOptions.Position, .. ScanOptions.OfTrajectory, .. MissionOptions.All,
            Epoch, Time, Times, TimeInterval, Attitude, AttitudeTransition, AttitudeFrame, OrbitFrame, .. PointingOptions.OfPosition,
            .. BatchOptions.All, Normalize, Motion,
        ])
    {
        Note =
            "Exactly one of the first five, --trajectory, or --spacecraft. An orbit (-k, -s) needs --epoch; it and --position need one "
                + "of --time, "
                + "--times and --time-interval. A time is an MJD (UTC) or ISO 8601 with its zone, e.g. 2024-01-19T12:00:00Z. "
                + "Values in braces are quoted. docs/camera-model.md draws the axes.",
    };
}
