namespace Msisf.Core.Tiles.Selection;

/// <summary>A point in the half planes of a <see cref="PolarView"/>.</summary>
/// <param name="East">m across the axis.</param>
/// <param name="North">m across the axis, at right angles to <paramref name="East"/>.</param>
/// <param name="Rise">m along the axis, over the viewpoint.</param>
/// <param name="Arc">Sine of half the angle from the axis at the Moon's centre; it increases along each ray from the viewpoint.</param>
/// <param name="Azimuth">rad in (-pi, pi].</param>
internal readonly record struct PolarPoint(double East, double North, double Rise, double Arc, double Azimuth)
{
    /// <summary>Distance from the axis, m.</summary>
    public double Across => Math.Sqrt((East * East) + (North * North));
}
