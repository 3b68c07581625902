using Msisf.Core.Attitude;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>Turns the positions and attitudes of a batch file into those of MOON_ME.</summary>
internal sealed class BatchFrame
{
    private readonly OrbitFrame _frame;
    private readonly AttitudeConvention _attitude;
    private readonly bool _normalizes;
    private readonly ISceneGeometry _scene;
    private readonly RotationMatrix _j2000FromFrame = RotationMatrix.Identity;

    /// <summary>Takes how the numbers are meant.</summary>
    /// <param name="conventions">What the file and the options say.</param>
    /// <param name="scene">How the Moon turns; asked for other frames than MOON_ME only.</param>
    /// <exception cref="BadInputException">The frame needs an epoch.</exception>
    public BatchFrame(BatchConventions conventions, ISceneGeometry scene)
    {
        (_frame, _normalizes, _scene) = (conventions.Frame ?? OrbitFrame.MoonMe, conventions.Normalizes, scene);
        _attitude = new AttitudeConvention(conventions.Axes ?? default, conventions.Rotation ?? default);
        if (_frame == OrbitFrame.MoonMeEpoch)
        {
            CalendarTime epoch = conventions.Epoch
                ?? throw new BadInputException(
                    "frame moon-me-epoch needs the epoch whose axes are held still: --epoch, or epoch= beside it.");
            _j2000FromFrame = scene.BodyFromJ2000(scene.TimeScale.InstantOf(epoch)).Transposed;
        }
    }

    /// <summary>Whether positions and attitudes are fixed to the body at their time.</summary>
    public bool IsBodyFixed => _frame == OrbitFrame.MoonMe;

    /// <summary>A position as one fixed to the body.</summary>
    /// <param name="position">m, in the frame of the file.</param>
    public Vector3D PositionBodyFixed(Instant time, Vector3D position) =>
        IsBodyFixed ? position : MoonFromFrame(time) * position;

    /// <summary>The attitude of a quaternion.</summary>
    /// <param name="numbers">qx, qy, qz, q0 as the file has them.</param>
    /// <exception cref="BadInputException">They are not a rotation.</exception>
    public UnitQuaternion OfQuaternion(Instant time, ReadOnlySpan<double> numbers) =>
        MoonFromCamera(time, UnitQuaternion.FromComponents(numbers[0], numbers[1], numbers[2], numbers[3], _normalizes));

    /// <summary>The attitude of a matrix.</summary>
    /// <param name="numbers">By rows, as the file has them.</param>
    /// <exception cref="BadInputException">They are not a rotation.</exception>
    public UnitQuaternion OfMatrix(Instant time, ReadOnlySpan<double> numbers) =>
        MoonFromCamera(time, GivenRotation.OfMatrix(numbers, _normalizes));

    /// <summary>The attitude of a rotation as the file means it.</summary>
    /// <param name="given">In the file's frame and axes.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into Moon axes.</returns>
    public UnitQuaternion MoonFromCamera(Instant time, UnitQuaternion given)
    {
        UnitQuaternion frameFromCamera = _attitude.FrameFromCamera(given);
        return IsBodyFixed ? frameFromCamera : UnitQuaternion.FromMatrix(MoonFromFrame(time)) * frameFromCamera;
    }

    private RotationMatrix MoonFromFrame(Instant time) => _scene.BodyFromJ2000(time) * _j2000FromFrame;
}
