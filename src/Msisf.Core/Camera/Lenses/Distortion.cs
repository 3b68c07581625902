using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// A formula between the ideal image plane, as a pinhole has it, and the measured one, as the lens has it. Both are in units of the focal
/// length, x to the right and y down, from the principal point. Immutable.
/// </summary>
/// <remarks>
/// Evaluated for eight points at a time by plain products and sums, without fused operations, so that a point alone gets the same bits.
/// </remarks>
public abstract class Distortion
{
    /// <summary>Name of the formula, as the meta file has it.</summary>
    public abstract string Name { get; }

    /// <summary>Coefficients of the formula (docs/cameras.md), with coordinates in units of the focal length.</summary>
    public abstract IReadOnlyList<double> Coefficients { get; }

    /// <summary>Whether it leaves every point where it is.</summary>
    public abstract bool IsNone { get; }

    /// <summary>Whether the formula goes from ideal to measured points; false if it goes from measured to ideal ones.</summary>
    internal abstract bool IsFromIdeal { get; }

    /// <summary>Applies the formula.</summary>
    /// <param name="points">Points of the plane that the formula begins with.</param>
    /// <param name="slopes">Derivatives at these points.</param>
    /// <returns>The points in the other plane; NaN where the formula has no value.</returns>
    internal abstract LanePoints Apply(in LanePoints points, out LaneSlopes slopes);
}

/// <summary>Eight points of the image plane, in units of the focal length, x to the right and y down, from the principal point.</summary>
internal readonly record struct LanePoints(Vector512<double> X, Vector512<double> Y)
{
    /// <summary>The same point eight times.</summary>
    public static LanePoints All(double x, double y) => new(Vector512.Create(x), Vector512.Create(y));
}

/// <summary>Derivatives of eight mapped points.</summary>
/// <param name="Xx">Derivative of the new x with respect to x.</param>
/// <param name="Xy">Derivative of the new x with respect to y.</param>
/// <param name="Yx">Derivative of the new y with respect to x.</param>
/// <param name="Yy">Derivative of the new y with respect to y.</param>
internal readonly record struct LaneSlopes(
    Vector512<double> Xx, Vector512<double> Xy, Vector512<double> Yx, Vector512<double> Yy)
{
    /// <summary>Above 0 where the mapping can be inverted and does not mirror.</summary>
    public Vector512<double> Determinant => (Xx * Yy) - (Xy * Yx);
}
