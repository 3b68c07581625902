using Msisf.Core.Numerics;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Attitude;

/// <summary>q0 exp(w t / 2) to some 30 digits; q0 (brought to length 1) and w are taken as exact.</summary>
internal sealed class TurningAttitude
{
    private readonly PreciseVector _vector;
    private readonly DoubleWord _scalar;
    private readonly PreciseVector _axis;
    private readonly DoubleWord _rate;

    private TurningAttitude(UnitQuaternion atEpoch, Vector3D rate)
    {
        AtEpoch = atEpoch;
        Rate = rate;
        DoubleWord inverse = 1.0 / DoubleWord.Sqrt(SquareOf(atEpoch));
        _vector = inverse * new PreciseVector(atEpoch.X, atEpoch.Y, atEpoch.Z);
        _scalar = inverse * atEpoch.W;
        _rate = PreciseVector.From(rate).Length;
        _axis = PreciseVector.From(rate).Normalized();
    }

    public UnitQuaternion AtEpoch { get; }

    /// <summary>rad/s about the camera's axes.</summary>
    public Vector3D Rate { get; }

    public static TurningAttitude Random(CaseRandom random) => new(random.Attitude(), random.Logarithmic(1e-9, 10.0) * random.Direction());

    /// <summary>How far the length of a quaternion is from 1.</summary>
    public static double LengthError(UnitQuaternion q) => Math.Abs((SquareOf(q) - 1.0).High) / 2.0;

    /// <summary>How far a quaternion is from the right one; q and -q are the same rotation.</summary>
    public double DistanceAt(double seconds, UnitQuaternion found)
    {
        DoubleWord angle = PreciseMath.ToHalfTurn(_rate * seconds);
        (DoubleWord sin, DoubleWord cos) = PreciseMath.SinCos(0.5 * angle);
        PreciseVector turn = sin * _axis;
        PreciseVector vector = (_scalar * turn) + (cos * _vector) + PreciseVector.Cross(_vector, turn);
        DoubleWord scalar = (_scalar * cos) - PreciseVector.Dot(_vector, turn);
        Vector3D foundVector = new(found.X, found.Y, found.Z);
        bool isOpposite = (scalar.High * found.W) + Vector3D.Dot(vector.Rounded, foundVector) < 0.0;
        double sign = isOpposite ? -1.0 : 1.0;
        return double.Hypot(
            PreciseVector.Distance(PreciseVector.From(sign * foundVector), vector),
            ((sign * found.W) - scalar).High);
    }

    private static DoubleWord SquareOf(UnitQuaternion q)
    {
        PreciseVector vector = new(q.X, q.Y, q.Z);
        return PreciseVector.Dot(vector, vector) + ((DoubleWord)q.W * q.W);
    }
}
