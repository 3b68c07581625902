namespace Msisf.Core.Attitude;

/// <summary>
/// An attitude that turns at a constant rate about the spacecraft's own axes: q(t) = q0 exp(w dt / 2) (docs/deviations.md, row 18). It is
/// computed in closed form, so errors do not build up.
/// </summary>
public sealed class AttitudeTransition
{
    private readonly UnitQuaternion _frameFromCameraAtEpoch;
    private readonly double _rate;
    private readonly double _rateCorrection;

    /// <summary>Takes attitude and rate.</summary>
    /// <param name="frameFromCameraAtEpoch">Attitude at the epoch, in any frame.</param>
    /// <param name="angularVelocityCamera">
    /// rad/s about the camera's axes (looks along -x, y right, z up), right-handed; zero holds the attitude.
    /// </param>
    /// <exception cref="BadInputException">The angular velocity is not finite.</exception>
    /// <exception cref="ArgumentException">The attitude is <c>default</c>.</exception>
    public AttitudeTransition(UnitQuaternion frameFromCameraAtEpoch, Vector3D angularVelocityCamera)
    {
        if (frameFromCameraAtEpoch == default)
        {
            throw new ArgumentException("No rotation: the quaternion was never set.", nameof(frameFromCameraAtEpoch));
        }

        _frameFromCameraAtEpoch = frameFromCameraAtEpoch;
        AngularVelocityCamera = angularVelocityCamera;
        _rate = Guard.Finite(angularVelocityCamera.Length, "The angular velocity (rad/s)");
        _rateCorrection = _rate == 0.0 ? 0.0 : LostInLength(angularVelocityCamera, _rate);
    }

    /// <summary>rad/s about the camera's axes.</summary>
    public Vector3D AngularVelocityCamera { get; }

    /// <summary>The attitude at a time: turns camera axes into those of the frame.</summary>
    /// <param name="secondsSinceEpoch">s, finite, may be negative.</param>
    /// <exception cref="BadInputException">The angle turned is beyond the largest double.</exception>
    public UnitQuaternion At(double secondsSinceEpoch)
    {
        if (_rate == 0.0)
        {
            return _frameFromCameraAtEpoch;
        }

        double angle = _rate * secondsSinceEpoch;
        if (!double.IsFinite(angle))
        {
            throw new BadInputException(Invariant(
                $"The attitude can't be followed for {secondsSinceEpoch:R} s at {_rate:R} rad/s; "
                    + $"check the angular velocity and the epoch."));
        }

        // The rounding errors of length and product grow with the angle, so they are added again.
        double angleError = Math.FusedMultiplyAdd(_rate, secondsSinceEpoch, -angle) + (_rateCorrection * secondsSinceEpoch);
        return _frameFromCameraAtEpoch
            * UnitQuaternion.FromAxisAngle(AngularVelocityCamera, AngleReduction.ToHalfTurn(angle, angleError));
    }

    /// <summary>What the rounding of a vector's length to a double has left out.</summary>
    private static double LostInLength(Vector3D vector, double length)
    {
        // Scaled to about 1: no square overflows.
        int exponent = Math.ILogB(length);
        double scaledLength = Math.ScaleB(length, -exponent);
        DoubleDouble defect = Square(Math.ScaleB(vector.X, -exponent))
            + Square(Math.ScaleB(vector.Y, -exponent))
            + Square(Math.ScaleB(vector.Z, -exponent))
            + (new DoubleDouble(-scaledLength, 0.0) * new DoubleDouble(scaledLength, 0.0));
        return Math.ScaleB(defect.High / (2.0 * scaledLength), exponent);
    }

    private static DoubleDouble Square(double a) => new DoubleDouble(a, 0.0) * new DoubleDouble(a, 0.0);
}
