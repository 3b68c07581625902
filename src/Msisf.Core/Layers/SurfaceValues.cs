using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tiles;

namespace Msisf.Core.Layers;

/// <summary>Layer values of the position and shape of the surface at a pixel.</summary>
internal static class SurfaceValues
{
    /// <summary>m, along the ray; from the ray's parameter, so it keeps its digits when the ground is near.</summary>
    public static double? Range(PixelTruth pixel, int plane) => pixel.Hit.RayParameter * pixel.LineOfSightLength;

    /// <summary>m, along the optical axis: the ray's direction is one image plane distance long on it.</summary>
    public static double? Depth(PixelTruth pixel, int plane) => pixel.Hit.RayParameter * pixel.AxisLength;

    /// <summary>m: see <see cref="PixelBeam"/>.</summary>
    public static double? PixelScale(PixelTruth pixel, int plane) => PixelBeam.SideAt(
        pixel.Camera, new Ray(pixel.Camera.PositionMoonMe, pixel.LineOfSightMoonMe), pixel.Hit.RayParameter);

    public static double? Position(PixelTruth pixel, int plane) => Component(pixel.Hit.PointMoonMe, plane);

    public static double? Normal(PixelTruth pixel, int plane) => Component(pixel.Hit.NormalMoonMe, plane);

    public static double? Latitude(PixelTruth pixel, int plane) => double.RadiansToDegrees(pixel.Place.Latitude);

    public static double? Longitude(PixelTruth pixel, int plane) => double.RadiansToDegrees(pixel.Place.Longitude);

    public static double? Height(PixelTruth pixel, int plane) => pixel.Radius - pixel.ReferenceRadius;

    public static double? Cell(PixelTruth pixel, int plane) => plane == 0 ? pixel.Hit.Facet.Line : pixel.Hit.Facet.Sample;

    /// <summary>
    /// <see cref="TileId.Number"/> of the tile that the cell belongs to (docs/pattern-format.md); there are none on a polar map.
    /// </summary>
    public static double? Tile(PixelTruth pixel, int plane) => pixel.MeshPixelsPerDegree is { } pixelsPerDegree
        ? TileId.Holding(pixel.Hit.Facet, pixelsPerDegree).Number
        : null;

    private static double Component(Vector3D vector, int plane) => plane switch
    {
        0 => vector.X,
        1 => vector.Y,
        _ => vector.Z,
    };
}
