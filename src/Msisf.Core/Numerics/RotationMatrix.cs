namespace Msisf.Core.Numerics;

/// <summary>
/// A rotation as three rows; a variable that holds one is named result-from-source. <c>default</c> is not a rotation: use
/// <see cref="Identity"/>.
/// </summary>
/// <param name="Row0">First row: the first target axis, in source components.</param>
/// <param name="Row1">Second row.</param>
/// <param name="Row2">Third row.</param>
public readonly record struct RotationMatrix(Vector3D Row0, Vector3D Row1, Vector3D Row2)
{
    /// <summary>The rotation that changes nothing.</summary>
    public static RotationMatrix Identity => new(Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ);

    /// <summary>The inverse rotation.</summary>
    public RotationMatrix Transposed => new(
        new Vector3D(Row0.X, Row1.X, Row2.X),
        new Vector3D(Row0.Y, Row1.Y, Row2.Y),
        new Vector3D(Row0.Z, Row1.Z, Row2.Z));

    /// <summary>The three rows.</summary>
    public override string ToString() => $"[{Row0}, {Row1}, {Row2}]";

    /// <summary>Rotates a vector.</summary>
    public static Vector3D operator *(RotationMatrix m, Vector3D v) =>
        new(Vector3D.Dot(m.Row0, v), Vector3D.Dot(m.Row1, v), Vector3D.Dot(m.Row2, v));

    /// <summary>First <paramref name="n"/>, then <paramref name="m"/>.</summary>
    public static RotationMatrix operator *(RotationMatrix m, RotationMatrix n)
    {
        RotationMatrix columns = n.Transposed;
        return new RotationMatrix(columns * m.Row0, columns * m.Row1, columns * m.Row2);
    }

    /// <summary>The frame rotation about the first axis by an angle in rad, SPICE's [angle]_1.</summary>
    public static RotationMatrix FrameAboutX(double angle)
    {
        (double sin, double cos) = Trigonometry.SinCos(angle);
        return new RotationMatrix(Vector3D.UnitX, new Vector3D(0.0, cos, sin), new Vector3D(0.0, -sin, cos));
    }

    /// <summary>The frame rotation about the second axis by an angle in rad, SPICE's [angle]_2.</summary>
    public static RotationMatrix FrameAboutY(double angle)
    {
        (double sin, double cos) = Trigonometry.SinCos(angle);
        return new RotationMatrix(new Vector3D(cos, 0.0, -sin), Vector3D.UnitY, new Vector3D(sin, 0.0, cos));
    }

    /// <summary>The frame rotation about the third axis by an angle in rad, SPICE's [angle]_3.</summary>
    public static RotationMatrix FrameAboutZ(double angle)
    {
        (double sin, double cos) = Trigonometry.SinCos(angle);
        return new RotationMatrix(new Vector3D(cos, sin, 0.0), new Vector3D(-sin, cos, 0.0), Vector3D.UnitZ);
    }

    /// <summary>The frame rotation about the first, second or third axis by an angle in rad.</summary>
    /// <param name="axis">1, 2 or 3.</param>
    public static RotationMatrix FrameAbout(int axis, double angle) => axis switch
    {
        1 => FrameAboutX(angle),
        2 => FrameAboutY(angle),
        3 => FrameAboutZ(angle),
        _ => throw new ArgumentOutOfRangeException(nameof(axis)),
    };
}
