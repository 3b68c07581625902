using Msisf.Core.Numerics;

namespace Msisf.Stress.Reference;

/// <summary>A vector of three <see cref="DoubleWord"/>s.</summary>
public readonly record struct PreciseVector(DoubleWord X, DoubleWord Y, DoubleWord Z)
{
    /// <summary>The length.</summary>
    public DoubleWord Length => DoubleWord.Sqrt(Dot(this, this));

    /// <summary>Each component rounded to a double.</summary>
    public Vector3D Rounded => new(X.High, Y.High, Z.High);

    /// <summary>Exact.</summary>
    public static PreciseVector From(Vector3D v) => new(v.X, v.Y, v.Z);

    public static PreciseVector operator +(PreciseVector u, PreciseVector v) => new(u.X + v.X, u.Y + v.Y, u.Z + v.Z);

    public static PreciseVector operator -(PreciseVector u, PreciseVector v) => new(u.X - v.X, u.Y - v.Y, u.Z - v.Z);

    public static PreciseVector operator *(DoubleWord factor, PreciseVector v) => new(factor * v.X, factor * v.Y, factor * v.Z);

    public static DoubleWord Dot(PreciseVector u, PreciseVector v) => (u.X * v.X) + (u.Y * v.Y) + (u.Z * v.Z);

    public static PreciseVector Cross(PreciseVector u, PreciseVector v) =>
        new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));

    /// <summary>How far apart two vectors are.</summary>
    public static double Distance(PreciseVector u, PreciseVector v) => (u - v).Rounded.Length;

    /// <summary>The distance over the length of the right one.</summary>
    public static double RelativeError(PreciseVector found, PreciseVector right) => Distance(found, right) / right.Length.High;

    /// <summary>The vector of length 1 in the same direction.</summary>
    public PreciseVector Normalized() => (1.0 / Length) * this;
}
