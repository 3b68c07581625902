using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>The arguments of thesis table 6.1: where the spacecraft is, when, and how it points.</summary>
internal sealed class ModeOptions
{
    public Option<string[]> KeplerSet { get; } = OptionFactory.Words(
        "--kepler-set", ["-k"], "{a,e,omega,Omega,i,M0}",
        "Kepler orbit: semi-major axis (m), eccentricity, argument of periapsis, longitude of the ascending node, inclination, "
            + "mean anomaly at the epoch (rad)");

    public Option<string[]> StateVectors { get; } = OptionFactory.Words(
        "--state-vectors", ["-s"], "{rx,ry,rz,drx,dry,drz}", "Orbit by position (m) and velocity (m/s) at the epoch");

    public Option<string[]> FixedState { get; } = OptionFactory.Words(
        "--fixed-state", [], "{MJD,rx,ry,rz,qx,qy,qz,q0}", "One state: time, position (m, ME/PA) and orientation");

    public Option<string?> BatchFile { get; init; } = OptionFactory.Value(
        "--batch-file", [], "FILE", "Fixed states, one a line: MJD rx ry rz qx qy qz q0; # begins a comment; - reads standard input");

    public Option<string?> Epoch { get; } = OptionFactory.Value(
        "--epoch", ["-e"], "MJD", "Time for which the orbit and the attitude are given (UTC)");

    public Option<string?> Time { get; } = OptionFactory.Value("--time", ["-t"], "MJD", "Simulation time (UTC)");

    public Option<string[]> Times { get; } = OptionFactory.Words("--times", ["-tt"], "{MJD,MJD,...}", "Simulation times (UTC)");

    public Option<string?> TimeInterval { get; } = OptionFactory.Value(
        "--time-interval", [], "[start:step:end]", "Simulation times from start to end (MJD, UTC) in steps of days");

    public Option<string[]> Attitude { get; } = OptionFactory.Words(
        "--attitude", ["-a"], "{qx,qy,qz,q0}", "Orientation at the epoch; without it the camera looks at the nadir, north up");

    public Option<string[]> AttitudeTransition { get; } = OptionFactory.Words(
        "--attitude-transition", ["-at"], "{wx,wy,wz}", "Angular velocity about the spacecraft's own axes (rad/s), from the epoch on");

    public Option<string?> OrbitFrame { get; } = OptionFactory.Value(
        "--orbit-frame", [], "moon-me|moon-me-epoch|j2000",
        "Frame of the orbit: ME/PA that turns with the Moon (default), ME/PA of the epoch held still, or J2000");

    public IEnumerable<Option> All =>
    [
        KeplerSet, StateVectors, FixedState, BatchFile, Epoch, Time, Times, TimeInterval, Attitude, AttitudeTransition, OrbitFrame,
    ];
}
