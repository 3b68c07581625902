using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>Where the camera of each image is, in one of the ways of thesis section 6.3, or by its place.</summary>
internal abstract record TrajectorySettings
{
    /// <summary>How the camera moves during each exposure; null if the user does not say it.</summary>
    public CameraMotion? Motion { get; init; }

    /// <summary>m, MOON_ME: where the Sun is in all frames; null if the ephemeris, or each state, says it.</summary>
    public Vector3D? SunPositionBodyFixed { get; init; }

    /// <summary>By how much longer all frames are exposed; null if the user does not say it.</summary>
    public double? ExposureFactor { get; init; }

    /// <summary>The noise of the first frame; each frame after it has the next step. Null if the user does not choose it.</summary>
    public NoiseSeed? Noise { get; init; }
}

/// <summary>One image.</summary>
/// <param name="Time">UTC.</param>
/// <param name="State">All but the time, of which the leap seconds of the kernels make a moment.</param>
internal sealed record FixedStateSettings(CalendarTime Time, SpacecraftState State) : TrajectorySettings;

/// <summary>An image for each line of a file.</summary>
/// <param name="Path">The file; "-" for standard input.</param>
/// <param name="Option">The option that named it, for messages.</param>
internal sealed record BatchFileSettings(string Path, PathSpec Option) : TrajectorySettings
{
    /// <summary>Whether the states come from standard input, which can be read only once.</summary>
    public bool IsStandardInput => Path == "-";

    /// <summary>Its content, where it is not a file; null for a file.</summary>
    public string? Content { get; init; }

    /// <summary>How its numbers are meant, as far as the options say it.</summary>
    public BatchConventions Conventions { get; init; } = new();
}

/// <summary>Images along a motion that states are samples of.</summary>
/// <param name="Times">Times of the images, UTC; null for one at the first sample.</param>
internal sealed record SampledSettings(BatchFileSettings Samples, IEnumerable<CalendarTime>? Times) : TrajectorySettings
{
    /// <summary>How positions are found; null for Hermite where all samples have velocities, otherwise Lagrange.</summary>
    public InterpolationMethod? Positions { get; init; }

    /// <summary>How attitudes are found; null for Hermite where all samples have angular velocities, otherwise at constant rates.</summary>
    public AttitudePath? Attitudes { get; init; }
}

/// <summary>Images along an orbit.</summary>
/// <param name="Elements">Orbital elements at the epoch.</param>
/// <param name="Epoch">Epoch of the elements, UTC.</param>
/// <param name="Frame">Reference frame of the elements.</param>
/// <param name="IsFrameGiven">Whether the user chose the frame.</param>
/// <param name="Attitude">Attitude from the epoch on; null to point the camera at the nadir.</param>
/// <param name="AttitudeFrame">Frame of the attitude; null if the user did not choose it, which means MOON_ME.</param>
/// <param name="Times">Times of the images, UTC; may be empty.</param>
internal sealed record OrbitSettings(
    KeplerElements Elements, CalendarTime Epoch, OrbitFrame Frame, bool IsFrameGiven, AttitudeTransition? Attitude,
    AttitudeFrame? AttitudeFrame, IEnumerable<CalendarTime> Times) : TrajectorySettings;

/// <summary>Images from one place.</summary>
/// <param name="Place">Position of the camera.</param>
/// <param name="Pointing">How it points.</param>
/// <param name="Times">Times of the images, UTC; may be empty.</param>
internal sealed record PlaceSettings(
    SurfacePlace Place, CameraPointing Pointing, IEnumerable<CalendarTime> Times) : TrajectorySettings;

/// <summary>Images along the trajectory that the files of a mission give.</summary>
/// <param name="Position">Where the spacecraft is.</param>
/// <param name="Attitude">How its camera points.</param>
/// <param name="Times">Times of the images, UTC; null for steps of the files' cover.</param>
/// <param name="Every">s: step between images; null if <paramref name="Times"/> are given.</param>
internal sealed record MissionSettings(
    PositionSource Position, AttitudeChoice Attitude, IEnumerable<CalendarTime>? Times, double? Every) : TrajectorySettings
{
    /// <summary>What the finite speed of light does to the ground that is seen.</summary>
    public Aberration OfGround { get; init; }
}

/// <summary>Which file says where the spacecraft is.</summary>
internal abstract record PositionSource;

/// <summary>SPICE kernels: those of --spk, and all others.</summary>
/// <param name="Spacecraft">Its name or number.</param>
internal sealed record KernelPosition(string Spacecraft) : PositionSource;

/// <summary>A file of states: an OEM, or one of another program (<see cref="Adapters.Trajectories.TrajectoryFile"/>).</summary>
/// <param name="Path">The file.</param>
/// <param name="Option">The option that named it, for messages.</param>
internal sealed record FilePosition(string Path, PathSpec Option) : PositionSource;

/// <summary>States that are read, or can be.</summary>
/// <param name="Name">What they are called in messages.</param>
/// <param name="Blocks">Reads them, with the kernels of the engine.</param>
internal sealed record SampledPosition(string Name, Func<OpenedEphemeris, IReadOnlyList<TrajectoryBlock>> Blocks) : PositionSource;

/// <summary>What says how the camera points.</summary>
internal abstract record AttitudeChoice;

/// <summary>A target.</summary>
/// <param name="Pointing">What the camera looks at.</param>
internal sealed record PointedChoice(CameraPointing Pointing) : AttitudeChoice;

/// <summary>An attitude ephemeris message.</summary>
/// <param name="Path">The file.</param>
/// <param name="IsRounded">Whether its quaternions may be rounded to a few decimals.</param>
/// <param name="Axes">How the image lies in the spacecraft's axes; null for those of the camera itself.</param>
internal sealed record AemChoice(string Path, bool IsRounded, InstrumentAxes? Axes) : AttitudeChoice;

/// <summary>The CKs and frame kernels of an instrument.</summary>
/// <param name="Instrument">Its name or number.</param>
/// <param name="Axes">How the image lies in its axes; null for what its instrument kernel says.</param>
internal sealed record InstrumentChoice(string Instrument, InstrumentAxes? Axes) : AttitudeChoice;

/// <summary>A quaternion.</summary>
/// <param name="Attitude">From the epoch on.</param>
/// <param name="Epoch">UTC; null where the attitude does not change in its frame.</param>
internal sealed record QuaternionChoice(AttitudeTransition Attitude, AttitudeFrame Frame, CalendarTime? Epoch) : AttitudeChoice;
