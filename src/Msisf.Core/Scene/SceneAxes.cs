namespace Msisf.Core.Scene;

/// <summary>
/// Where a scene of POV-Ray has its origin, and in which unit it counts; its axes are those of MOON_ME (docs/pattern-format.md).
/// </summary>
/// <param name="OriginBodyFixed">m, body-fixed.</param>
/// <param name="UnitsPerKilometre">A power of two, at least 1.</param>
public sealed record SceneAxes(Vector3D OriginBodyFixed, double UnitsPerKilometre)
{
    /// <summary>Kilometres from the Moon's centre.</summary>
    public static SceneAxes MoonKilometres { get; } = new(default, 1.0);

    private const double MetresPerKilometre = 1000.0;

    /// <summary>
    /// POV-Ray takes nothing within a thousandth of a unit from a point for a caster of its shadow (SMALL_TOLERANCE), here 63 millionths of
    /// a cell: with a unit of half a cell 2 of 65,536 pixels were lit at the foot of slopes that shade them. The planes of its triangles
    /// are wrong by a millionth of a cell. With four times as many units blocks were infinite: POV-Ray 3.7 takes boxes above 2e10 cubic
    /// units (INFINITE_VOLUME) out of its tree and tests every ray against each.
    /// </summary>
    private const double UnitsPerCell = 16.0;

    /// <summary>Units: half of what POV-Ray 3.7 draws at most (its MAX_DISTANCE).</summary>
    private const double FarthestGround = 5e6;

    /// <summary>
    /// Axes for a camera. The origin is the camera: POV-Ray keeps boxes around meshes, and asks them with rays, in 32-bit floats, which
    /// from the Moon's centre are wrong by 0.1 m; there 7 of 65,536 pixels of cells of 1 m were lit through the ground. The unit is a small
    /// part of a cell, as far as the ground can be reached with it.
    /// </summary>
    /// <param name="cameraBodyFixed">Position of the camera, m, body-fixed.</param>
    /// <param name="moonRadius">m: the Moon's surface is nowhere farther from its centre.</param>
    /// <param name="cell">m: width of the narrowest cells.</param>
    public static SceneAxes For(Vector3D cameraBodyFixed, double moonRadius, double cell)
    {
        double wanted = Math.Ceiling(Math.Log2(UnitsPerCell * MetresPerKilometre / cell));
        double allowed = Math.Floor(Math.Log2(FarthestGround * MetresPerKilometre / (cameraBodyFixed.Length + moonRadius)));
        return new SceneAxes(cameraBodyFixed, Math.Pow(2.0, Math.Max(0.0, Math.Min(wanted, allowed))));
    }

    /// <summary>A position in the scene's axes and unit.</summary>
    /// <param name="positionBodyFixed">m, body-fixed.</param>
    public Vector3D At(Vector3D positionBodyFixed) => UnitsPerKilometre * ((positionBodyFixed - OriginBodyFixed) / MetresPerKilometre);
}
