using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>Images along the trajectory that the files of a mission give.</summary>
/// <param name="Position">Where the spacecraft is.</param>
/// <param name="Attitude">How its camera points.</param>
/// <param name="Times">Times of the images, UTC; null for steps of the files' cover.</param>
/// <param name="Every">s: step between images; null if <paramref name="Times"/> are given.</param>
internal sealed record MissionSettings(
    PositionSource Position, AttitudeChoice Attitude, IEnumerable<ModifiedJulianDate>? Times, double? Every) : TrajectorySettings
{
    /// <summary>What the finite speed of light does to the ground that is seen.</summary>
    public Aberration OfGround { get; init; }
}

/// <summary>Which file says where the spacecraft is.</summary>
internal abstract record PositionSource;

/// <summary>SPICE kernels: those of --spk, and all others.</summary>
/// <param name="Spacecraft">Its name or number.</param>
internal sealed record KernelPosition(string Spacecraft) : PositionSource;

/// <summary>An orbit ephemeris message.</summary>
/// <param name="Path">The file.</param>
internal sealed record OemPosition(string Path) : PositionSource;

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
internal sealed record QuaternionChoice(AttitudeTransition Attitude, AttitudeFrame Frame, ModifiedJulianDate? Epoch) : AttitudeChoice;
