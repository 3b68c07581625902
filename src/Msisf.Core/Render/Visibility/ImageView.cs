using Msisf.Core.Camera;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// A camera's image as the raster sees it: columns and rows from 0 at the pixel centres, x to the right, y down, for vertices that
/// are given from <see cref="Origin"/>, the point of the vertex lattice nearest to the camera, so that they and their differences are
/// exact.
/// </summary>
internal sealed class ImageView
{
    /// <summary>
    /// px: where a projected vertex may lie for its products to keep 1e-9 px; beyond it, its edges are computed in space.
    /// </summary>
    private const double MinCoordinateLimit = 32768.0;

    /// <summary>m from the Moon's centre: from here on a plane is known better from there than from the camera.</summary>
    private const double FarDistance = 2.0 * MoonConstants.ReferenceRadius;

    /// <param name="camera">The camera.</param>
    /// <param name="offsetX">px to the right, added to each pixel's centre.</param>
    /// <param name="offsetY">px down.</param>
    public ImageView(PinholeCamera camera, double offsetX, double offsetY)
    {
        Camera = camera;
        OffsetX = offsetX;
        OffsetY = offsetY;
        Vector3D position = camera.PositionMoonMe;
        Origin = new Vector3D(OnLattice(position.X), OnLattice(position.Y), OnLattice(position.Z));
        Remainder = position - Origin;
        Anchor = position.Length < FarDistance ? Origin : default;

        Distance = Vector3D.Dot(camera.Direction, camera.ForwardMoonMe);
        double aspect = (double)camera.Width / camera.Height;
        PixelsPerTangent = camera.Height * Distance;
        Across = (PixelsPerTangent / aspect) * camera.Right;
        Down = -PixelsPerTangent * camera.Up;
        Forward = camera.ForwardMoonMe;
        CentreX = ((camera.Width - 1) / 2.0) - offsetX;
        CentreY = ((camera.Height - 1) / 2.0) - offsetY;
        FirstRay = camera.RayThrough(1.0 + offsetX, 1.0 + offsetY).Direction;
        RayPerColumn = camera.Right / camera.Width;
        RayPerRow = -camera.Up / camera.Height;
        CoordinateLimit = Math.Max(MinCoordinateLimit, 4.0 * Math.Max(camera.Width, camera.Height));
    }

    /// <summary>The camera.</summary>
    public PinholeCamera Camera { get; }

    /// <summary>px to the right, added to each pixel's centre.</summary>
    public double OffsetX { get; }

    /// <summary>px down.</summary>
    public double OffsetY { get; }

    /// <summary>m, MOON_ME: a point of the vertex lattice, within 2^-7 m of the camera.</summary>
    public Vector3D Origin { get; }

    /// <summary>m: from the origin to the camera.</summary>
    public Vector3D Remainder { get; }

    /// <summary>
    /// m, MOON_ME: the lattice point that planes are given from; near the camera, or, for a camera far away, the Moon's centre.
    /// </summary>
    public Vector3D Anchor { get; }

    /// <summary>m: from the anchor to the origin, exact.</summary>
    public Vector3D OriginFromAnchor => Origin - Anchor;

    /// <summary>Part of each pixel's ray direction along the viewing direction: at parameter t a ray is t times this deep.</summary>
    public double Distance { get; }

    /// <summary>px a unit of the tangent of the angle from the viewing direction.</summary>
    public double PixelsPerTangent { get; }

    /// <summary>A vector from the camera times this, over its depth, is its column from <see cref="CentreX"/>.</summary>
    public Vector3D Across { get; }

    /// <summary>The same for rows and <see cref="CentreY"/>.</summary>
    public Vector3D Down { get; }

    /// <summary>A vector from the camera times this is its depth.</summary>
    public Vector3D Forward { get; }

    /// <summary>Column of the viewing direction.</summary>
    public double CentreX { get; }

    /// <summary>Row of the viewing direction.</summary>
    public double CentreY { get; }

    /// <summary>Ray direction of column 0, row 0.</summary>
    public Vector3D FirstRay { get; }

    /// <summary>What a column adds to the ray direction.</summary>
    public Vector3D RayPerColumn { get; }

    /// <summary>What a row adds.</summary>
    public Vector3D RayPerRow { get; }

    /// <summary>px: vertices that are projected farther out are not used as projected ones.</summary>
    public double CoordinateLimit { get; }

    /// <summary>
    /// px2: facets that are turned away by more than this certainly are; products of coordinates within the limit are rounded by less.
    /// </summary>
    public double BackFaceArea => Math.ScaleB(CoordinateLimit * CoordinateLimit, -50);

    /// <summary>
    /// What the image's samples show, half a pixel wider and by what rounding turns a projected direction (some 1e-16 rad).
    /// </summary>
    public ViewFrustum Frustum() => new(Camera, 0.5 + (PixelsPerTangent * 1e-14), null, OffsetX, OffsetY);

    private static double OnLattice(double metres) => Math.Round(metres * LatticePoint.StepsPerMetre) / LatticePoint.StepsPerMetre;
}
