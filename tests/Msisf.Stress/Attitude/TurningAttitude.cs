using Msisf.Core.Numerics;
using Msisf.Stress.Numerics;

namespace Msisf.Stress.Attitude;

/// <summary>q0 exp(w t / 2) in double-double; q0 (brought to length 1) and w are taken as exact.</summary>
internal sealed class TurningAttitude
{
    private readonly WideVector _vector;
    private readonly DoubleDouble _scalar;
    private readonly WideVector _axis;
    private readonly DoubleDouble _rate;

    private TurningAttitude(UnitQuaternion atEpoch, Vector3D rate)
    {
        AtEpoch = atEpoch;
        Rate = rate;
        DoubleDouble inverse = WideMath.Divide(WideMath.Of(1.0), WideMath.SquareRoot(SquareOf(atEpoch)));
        _vector = inverse * WideVector.Of(new Vector3D(atEpoch.X, atEpoch.Y, atEpoch.Z));
        _scalar = inverse * WideMath.Of(atEpoch.W);
        _rate = WideVector.Of(rate).Length;
        _axis = WideVector.Of(rate).Normalized;
    }

    public UnitQuaternion AtEpoch { get; }

    /// <summary>rad/s about the camera's axes.</summary>
    public Vector3D Rate { get; }

    public static TurningAttitude Random(CaseRandom random) => new(random.Attitude(), random.Logarithmic(1e-9, 10.0) * random.Direction());

    /// <summary>How far the length of a quaternion is from 1.</summary>
    public static double LengthError(UnitQuaternion q) => Math.Abs(WideMath.Subtract(SquareOf(q), WideMath.Of(1.0)).High) / 2.0;

    /// <summary>How far a quaternion is from the right one; q and -q are the same rotation.</summary>
    public double DistanceAt(double seconds, UnitQuaternion found)
    {
        DoubleDouble angle = WideMath.ToHalfTurn(_rate * WideMath.Of(seconds));
        (DoubleDouble sin, DoubleDouble cos) = WideMath.SinCos(WideMath.Multiply(0.5, angle));
        WideVector turn = sin * _axis;
        WideVector vector = (_scalar * turn) + (cos * _vector) + WideVector.Cross(_vector, turn);
        DoubleDouble scalar = WideMath.Subtract(_scalar * cos, WideVector.Dot(_vector, turn));
        Vector3D foundVector = new(found.X, found.Y, found.Z);
        bool isOpposite = (scalar.High * found.W) + Vector3D.Dot(new Vector3D(vector.X.High, vector.Y.High, vector.Z.High), foundVector) < 0.0;
        double sign = isOpposite ? -1.0 : 1.0;
        return double.Hypot(
            WideVector.Distance(WideVector.Of(sign * foundVector), vector),
            WideMath.Subtract(WideMath.Of(sign * found.W), scalar).High);
    }

    private static DoubleDouble SquareOf(UnitQuaternion q)
    {
        WideVector vector = WideVector.Of(new Vector3D(q.X, q.Y, q.Z));
        return WideVector.Dot(vector, vector) + (WideMath.Of(q.W) * WideMath.Of(q.W));
    }
}
