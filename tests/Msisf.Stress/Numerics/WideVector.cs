using Msisf.Core.Numerics;

namespace Msisf.Stress.Numerics;

/// <summary>A vector of three double-doubles.</summary>
internal readonly record struct WideVector(DoubleDouble X, DoubleDouble Y, DoubleDouble Z)
{
    /// <summary>Length, to about 100 bits.</summary>
    public DoubleDouble Length => WideMath.SquareRoot(Dot(this, this));

    /// <summary>The same direction with length 1.</summary>
    public WideVector Normalized => WideMath.Divide(WideMath.Of(1.0), Length) * this;

    public static WideVector Of(Vector3D v) => new(WideMath.Of(v.X), WideMath.Of(v.Y), WideMath.Of(v.Z));

    public static WideVector operator +(WideVector u, WideVector v) => new(u.X + v.X, u.Y + v.Y, u.Z + v.Z);

    public static WideVector operator *(DoubleDouble factor, WideVector v) => new(factor * v.X, factor * v.Y, factor * v.Z);

    public static DoubleDouble Dot(WideVector u, WideVector v) => (u.X * v.X) + (u.Y * v.Y) + (u.Z * v.Z);

    public static WideVector Cross(WideVector u, WideVector v) => new(
        WideMath.Subtract(u.Y * v.Z, u.Z * v.Y),
        WideMath.Subtract(u.Z * v.X, u.X * v.Z),
        WideMath.Subtract(u.X * v.Y, u.Y * v.X));

    /// <summary>How far apart two vectors are.</summary>
    public static double Distance(WideVector u, WideVector v) => new Vector3D(
        WideMath.Subtract(u.X, v.X).High,
        WideMath.Subtract(u.Y, v.Y).High,
        WideMath.Subtract(u.Z, v.Z).High).Length;

    /// <summary>The distance over the length of the right one.</summary>
    public static double RelativeError(Vector3D found, WideVector right) => Distance(Of(found), right) / right.Length.High;
}
