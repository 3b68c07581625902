namespace Msisf.Core.Camera;

/// <summary>
/// How a camera moves about the time of a frame: on a straight line, turning at a constant rate. <c>default</c> is at rest on the Moon.
/// </summary>
/// <param name="VelocityBodyFixed">m/s over the turning Moon, along the axes of MOON_ME.</param>
/// <param name="AngularVelocityCamera">
/// rad/s relative to MOON_ME, about the camera's axes (looks along -x, y right, z up), right-handed.
/// </param>
public readonly record struct CameraMotion(Vector3D VelocityBodyFixed, Vector3D AngularVelocityCamera)
{
    /// <summary>The six numbers in their order: velocity (m/s), angular velocity (rad/s).</summary>
    public static IReadOnlyList<string> NumberNames { get; } = ["vx", "vy", "vz", "wx", "wy", "wz"];

    /// <summary>Whether the camera does not move.</summary>
    public bool IsRest => this == default;

    /// <summary>Takes the six numbers.</summary>
    /// <param name="numbers">In the order of <see cref="NumberNames"/>.</param>
    /// <exception cref="BadInputException">A number is not finite.</exception>
    /// <exception cref="ArgumentException">Not six numbers.</exception>
    public static CameraMotion FromNumbers(ReadOnlySpan<double> numbers) => numbers.Length == NumberNames.Count
        ? new CameraMotion(
            new Vector3D(Guard.Finite(numbers[0], "vx (m/s)"), Guard.Finite(numbers[1], "vy (m/s)"), Guard.Finite(numbers[2], "vz (m/s)")),
            new Vector3D(
                Guard.Finite(numbers[3], "wx (rad/s)"), Guard.Finite(numbers[4], "wy (rad/s)"), Guard.Finite(numbers[5], "wz (rad/s)")))
        : throw new ArgumentException($"{numbers.Length} numbers for a motion of {NumberNames.Count}.", nameof(numbers));

    /// <summary>The motion from one state to another.</summary>
    /// <param name="before">Position (m, MOON_ME) and orientation.</param>
    /// <param name="after">The same, later.</param>
    /// <param name="seconds">Time between them, above 0. The camera must turn by less than half a turn.</param>
    public static CameraMotion Between(
        (Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera) before,
        (Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera) after,
        double seconds)
    {
        UnitQuaternion turn = before.MoonFromCamera.Conjugate * after.MoonFromCamera;
        Vector3D sine = new(turn.X, turn.Y, turn.Z); // of half the angle, along the axis
        double length = sine.Length;
        double angle = 2.0 * Trigonometry.Atan2(length, Math.Abs(turn.W));
        return new CameraMotion(
            (after.PositionBodyFixed - before.PositionBodyFixed) / seconds,
            length == 0.0 ? default : angle * (turn.W < 0.0 ? -1.0 : 1.0) / (length * seconds) * sine);
    }

    /// <summary>The six numbers in the order of <see cref="NumberNames"/>.</summary>
    public double[] ToNumbers() =>
    [
        VelocityBodyFixed.X, VelocityBodyFixed.Y, VelocityBodyFixed.Z, AngularVelocityCamera.X, AngularVelocityCamera.Y,
        AngularVelocityCamera.Z,
    ];

    /// <summary>Where a camera is some time after, or before.</summary>
    /// <param name="state">The camera at first.</param>
    /// <param name="seconds">s.</param>
    public CameraState Moved(CameraState state, double seconds)
    {
        double rate = AngularVelocityCamera.Length;
        return state with
        {
            PositionBodyFixed = state.PositionBodyFixed + (seconds * VelocityBodyFixed),
            MoonFromCamera = rate == 0.0
                ? state.MoonFromCamera
                : state.MoonFromCamera * UnitQuaternion.FromAxisAngle(AngularVelocityCamera, rate * seconds),
            Seconds = state.Seconds + seconds,
        };
    }
}
