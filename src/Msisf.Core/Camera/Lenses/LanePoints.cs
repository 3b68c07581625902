using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>Eight points of the image plane, in units of the focal length, x to the right and y down, from the principal point.</summary>
internal readonly record struct LanePoints(Vector512<double> X, Vector512<double> Y)
{
    /// <summary>The same point eight times.</summary>
    public static LanePoints All(double x, double y) => new(Vector512.Create(x), Vector512.Create(y));
}

/// <summary>Derivatives of eight mapped points.</summary>
/// <param name="Xx">Of the new x with respect to x.</param>
/// <param name="Xy">Of the new x with respect to y.</param>
/// <param name="Yx">Of the new y with respect to x.</param>
/// <param name="Yy">Of the new y with respect to y.</param>
internal readonly record struct LaneSlopes(
    Vector512<double> Xx, Vector512<double> Xy, Vector512<double> Yx, Vector512<double> Yy)
{
    /// <summary>Above 0 where the mapping can be inverted and does not mirror.</summary>
    public Vector512<double> Determinant => (Xx * Yy) - (Xy * Yx);
}
