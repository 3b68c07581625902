namespace Msisf.Core.Numerics;

/// <summary>
/// A rotation as a quaternion q0 + qx i + qy j + qz k of length 1 (thesis chapter 7). <c>default</c> is not a rotation and is refused
/// wherever it is used: make one with <see cref="FromComponents"/> or take <see cref="Identity"/>.
/// </summary>
public readonly record struct UnitQuaternion
{
    private UnitQuaternion(double x, double y, double z, double w)
    {
        X = x;
        Y = y;
        Z = z;
        W = w;
    }

    /// <summary>The rotation that changes nothing.</summary>
    public static UnitQuaternion Identity => new(0.0, 0.0, 0.0, 1.0);

    /// <summary>Coefficient of i.</summary>
    public double X { get; }

    /// <summary>Coefficient of j.</summary>
    public double Y { get; }

    /// <summary>Coefficient of k.</summary>
    public double Z { get; }

    /// <summary>Real part, the thesis's q0.</summary>
    public double W { get; }

    /// <summary>The inverse rotation.</summary>
    public UnitQuaternion Conjugate => new(-X, -Y, -Z, W);

    /// <summary>"{qx,qy,qz,q0}", to the last digit, whatever the culture.</summary>
    public override string ToString() => Invariant($"{{{X:R},{Y:R},{Z:R},{W:R}}}");

    /// <summary>Checks and normalises four components.</summary>
    /// <param name="qx">Coefficient of i.</param>
    /// <param name="qy">Coefficient of j.</param>
    /// <param name="qz">Coefficient of k.</param>
    /// <param name="q0">Real part.</param>
    /// <param name="isRounded">Whether the components may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">
    /// Not finite, or the length is further than <see cref="Tolerances.UnitQuaternionLength"/>, of rounded ones
    /// <see cref="Tolerances.RoundedRotation"/>, from 1.
    /// </exception>
    public static UnitQuaternion FromComponents(double qx, double qy, double qz, double q0, bool isRounded = false)
    {
        double length = double.Hypot(double.Hypot(qx, qy), double.Hypot(qz, q0));
        double error = Math.Abs(length - 1.0);
        if (!(error <= (isRounded ? Tolerances.RoundedRotation : Tolerances.UnitQuaternionLength)))
        {
            string cure = error <= Tolerances.RoundedRotation
                ? "write each number with at least 7 decimals, or give --normalize."
                : "rounding does not explain it; check the numbers and their order.";
            throw new BadInputException(Invariant(
                $"The quaternion {{{qx:R},{qy:R},{qz:R},{q0:R}}} has length {length:R}; "
                    + $"a rotation needs length 1 within {Tolerances.UnitQuaternionLength:R}: {cure}"));
        }

        // What was normalised once stays as it is, to the last bit: a state that is written out and read back is the same.
        return Math.Abs(length - 1.0) <= Tolerances.RoundedUnitLength
            ? new UnitQuaternion(qx, qy, qz, q0)
            : new UnitQuaternion(qx / length, qy / length, qz / length, q0 / length);
    }

    /// <summary>The rotation by an angle about an axis, right-handed.</summary>
    /// <param name="axis">Any vector with a direction.</param>
    /// <param name="angle">rad.</param>
    public static UnitQuaternion FromAxisAngle(Vector3D axis, double angle)
    {
        (double sin, double cos) = Trigonometry.SinCos(angle / 2.0);
        Vector3D vector = sin * axis.Normalized();
        return new UnitQuaternion(vector.X, vector.Y, vector.Z, cos);
    }

    /// <summary>The quaternion of a rotation matrix, real part not negative.</summary>
    /// <remarks>S. W. Shepperd, J. Guidance and Control 1 (1978) 223: divides by the largest of the four, so nothing cancels.</remarks>
    public static UnitQuaternion FromMatrix(RotationMatrix m)
    {
        double xx = m.Row0.X;
        double yy = m.Row1.Y;
        double zz = m.Row2.Z;
        double[] fourSquares = [1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz, 1.0 + xx + yy + zz];
        int largest = Array.IndexOf(fourSquares, fourSquares.Max());
        (double x, double y, double z, double w) = largest switch
        {
            0 => (fourSquares[0], m.Row1.X + m.Row0.Y, m.Row2.X + m.Row0.Z, m.Row2.Y - m.Row1.Z),
            1 => (m.Row1.X + m.Row0.Y, fourSquares[1], m.Row2.Y + m.Row1.Z, m.Row0.Z - m.Row2.X),
            2 => (m.Row2.X + m.Row0.Z, m.Row2.Y + m.Row1.Z, fourSquares[2], m.Row1.X - m.Row0.Y),
            _ => (m.Row2.Y - m.Row1.Z, m.Row0.Z - m.Row2.X, m.Row1.X - m.Row0.Y, fourSquares[3]),
        };
        double length = double.Hypot(double.Hypot(x, y), double.Hypot(z, w));
        double signed = w < 0.0 ? -length : length;
        return new UnitQuaternion(x / signed, y / signed, z / signed, w / signed);
    }

    /// <summary>First <paramref name="q"/>, then <paramref name="p"/>; the product is normalised again.</summary>
    public static UnitQuaternion operator *(UnitQuaternion p, UnitQuaternion q)
    {
        double w = (p.W * q.W) - (p.X * q.X) - (p.Y * q.Y) - (p.Z * q.Z);
        double x = (p.W * q.X) + (p.X * q.W) + (p.Y * q.Z) - (p.Z * q.Y);
        double y = (p.W * q.Y) - (p.X * q.Z) + (p.Y * q.W) + (p.Z * q.X);
        double z = (p.W * q.Z) + (p.X * q.Y) - (p.Y * q.X) + (p.Z * q.W);
        double length = double.Hypot(double.Hypot(x, y), double.Hypot(z, w));
        return new UnitQuaternion(x / length, y / length, z / length, w / length);
    }

    /// <summary>Rotates a vector: q [0, v] q* (thesis eq. 7.18).</summary>
    public static Vector3D operator *(UnitQuaternion q, Vector3D v)
    {
        Vector3D imaginary = new(q.X, q.Y, q.Z);
        Vector3D twiceCross = 2.0 * Vector3D.Cross(imaginary, v);
        return v + (q.W * twiceCross) + Vector3D.Cross(imaginary, twiceCross);
    }
}
