using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Layers;

/// <summary>Layer values of the position and shape of the surface at a pixel.</summary>
internal static class SurfaceValues
{
    /// <summary>m, along the ray; from the ray's parameter, so it keeps its digits when the ground is near.</summary>
    public static double? Range(in PixelTruth pixel, int plane) => pixel.Hit.RayParameter * pixel.LineOfSightMoonMe.Length;

    /// <summary>m, along the optical axis: the ray's direction is one image plane distance long on it.</summary>
    public static double? Depth(in PixelTruth pixel, int plane) => pixel.Hit.RayParameter * pixel.Camera.Direction.Length;

    /// <summary>m: see <see cref="PixelBeam"/>.</summary>
    public static double? PixelScale(in PixelTruth pixel, int plane) => PixelBeam.SideAt(
        pixel.Camera, new Ray(pixel.Camera.PositionMoonMe, pixel.LineOfSightMoonMe), pixel.Hit.RayParameter);

    public static double? Position(in PixelTruth pixel, int plane) => Component(pixel.Hit.PointMoonMe, plane);

    public static double? Normal(in PixelTruth pixel, int plane) => Component(pixel.Hit.NormalMoonMe, plane);

    public static double? Latitude(in PixelTruth pixel, int plane) =>
        double.RadiansToDegrees(SelenographicPoint.Below(pixel.Hit.PointMoonMe).Latitude);

    public static double? Longitude(in PixelTruth pixel, int plane) =>
        double.RadiansToDegrees(SelenographicPoint.Below(pixel.Hit.PointMoonMe).Longitude);

    public static double? Height(in PixelTruth pixel, int plane) => pixel.Hit.PointMoonMe.Length - MoonConstants.ReferenceRadius;

    public static double? Cell(in PixelTruth pixel, int plane) => plane == 0 ? pixel.Hit.Facet.Line : pixel.Hit.Facet.Sample;

    /// <summary>
    /// <see cref="TileId.Number"/> of the tile that the cell belongs to (docs/pattern-format.md); there are none on a polar map.
    /// </summary>
    public static double? Tile(in PixelTruth pixel, int plane) => pixel.MeshPixelsPerDegree is { } pixelsPerDegree
        ? TileId.Holding(pixel.Hit.Facet, pixelsPerDegree).Number
        : null;

    private static double Component(Vector3D vector, int plane) => plane switch
    {
        0 => vector.X,
        1 => vector.Y,
        _ => vector.Z,
    };
}
