using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Core.Attitude;

/// <summary>
/// An attitude that turns at a constant rate about the spacecraft's own axes: q(t) = q0 exp(w dt / 2) (docs/deviations.md, row 18).
/// In closed form, so nothing drifts.
/// </summary>
public sealed class AttitudeTransition
{
    private readonly UnitQuaternion _moonFromCameraAtEpoch;
    private readonly Vector3D _angularVelocityCamera;
    private readonly double _rate;

    /// <summary>Takes attitude and rate.</summary>
    /// <param name="moonFromCameraAtEpoch">Attitude at the epoch.</param>
    /// <param name="angularVelocityCamera">rad/s about the camera's axes (looks along -x, y right, z up), right-handed; zero holds the attitude.</param>
    /// <exception cref="BadInputException">The angular velocity is not finite.</exception>
    /// <exception cref="ArgumentException">The attitude is <c>default</c>.</exception>
    public AttitudeTransition(UnitQuaternion moonFromCameraAtEpoch, Vector3D angularVelocityCamera)
    {
        if (moonFromCameraAtEpoch == default)
        {
            throw new ArgumentException("No rotation: the quaternion was never set.", nameof(moonFromCameraAtEpoch));
        }

        _moonFromCameraAtEpoch = moonFromCameraAtEpoch;
        _angularVelocityCamera = angularVelocityCamera;
        _rate = Guard.Finite(angularVelocityCamera.Length, "The angular velocity (rad/s)");
    }

    /// <summary>The attitude at a time: turns camera axes into Moon axes.</summary>
    /// <param name="secondsSinceEpoch">s, finite, may be negative.</param>
    /// <exception cref="BadInputException">The angle turned is beyond the largest double.</exception>
    public UnitQuaternion At(double secondsSinceEpoch)
    {
        if (_rate == 0.0)
        {
            return _moonFromCameraAtEpoch;
        }

        double angle = _rate * secondsSinceEpoch;
        if (!double.IsFinite(angle))
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"The attitude can't be followed for {secondsSinceEpoch:R} s at {_rate:R} rad/s; check the angular velocity and the epoch."));
        }

        // The digits that the product loses are turns after some years.
        double angleError = Math.FusedMultiplyAdd(_rate, secondsSinceEpoch, -angle);
        return _moonFromCameraAtEpoch
            * UnitQuaternion.FromAxisAngle(_angularVelocityCamera, AngleReduction.ToHalfTurn(angle, angleError));
    }
}
