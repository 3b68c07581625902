using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The projection from space to the pixels of a camera's image. Columns and rows count from 0 at the pixel centres, x to the right and y
/// down. Vertices are given relative to <see cref="Origin"/>, the point of the vertex lattice nearest to the camera, so that they and their
/// differences are exact.
/// </summary>
internal sealed class ImageView
{
    /// <summary>
    /// px: minimum of <see cref="CoordinateLimit"/>. Within it the products of projected coordinates keep 1e-9 px; the edges of vertices
    /// beyond it are computed in space.
    /// </summary>
    private const double MinCoordinateLimit = 32768.0;

    /// <summary>
    /// m: a camera at this distance or farther from the Moon's centre has that centre as its anchor, because plane offsets are more
    /// accurate from there.
    /// </summary>
    private const double FarDistance = 2.0 * MoonConstants.ReferenceRadius;

    private readonly LensSamples? _lens;

    /// <param name="lens">The samples of a camera with a lens; null for a pinhole.</param>
    /// <param name="tile">The tile of the lens's image that is drawn; null for the whole image.</param>
    public ImageView(FrameCamera camera, LensSamples? lens = null, LensTile? tile = null)
    {
        _lens = lens;
        Camera = camera;
        Vector3D position = camera.PositionBodyFixed;
        Origin = new Vector3D(OnLattice(position.X), OnLattice(position.Y), OnLattice(position.Z));
        Remainder = position - Origin;
        Anchor = position.Length < FarDistance ? Origin : default;

        Forward = camera.ForwardBodyFixed;
        CoordinateLimit = Math.Max(MinCoordinateLimit, 4.0 * Math.Max(camera.Width, camera.Height));
        if (!camera.Model.IsThesis)
        {
            ImagePlaneMap map = tile?.Map ?? ImagePlaneMap.Of(camera.Model);
            Distance = camera.ImagePlaneDistance;
            PixelsPerTangent = Math.Max(camera.Model.FocalX, camera.Model.FocalY);
            Across = (map.ColumnPerRight * camera.UnitRight) - (map.ColumnPerDown * camera.UnitUp);
            Down = (map.RowPerRight * camera.UnitRight) - (map.RowPerDown * camera.UnitUp);
            (CentreX, CentreY) = (map.Column0, map.Row0);
            FirstRay = RayAt(map, 0.0, 0.0);
            RayPerColumn = RayAt(map, 1.0, 0.0) - FirstRay;
            RayPerRow = RayAt(map, 0.0, 1.0) - FirstRay;
            return;
        }

        Distance = Vector3D.Dot(camera.Direction, camera.ForwardBodyFixed);
        double aspect = (double)camera.Width / camera.Height;
        PixelsPerTangent = camera.Height * Distance;
        Across = (PixelsPerTangent / aspect) * camera.Right;
        Down = -PixelsPerTangent * camera.Up;
        CentreX = (camera.Width - 1) / 2.0;
        CentreY = (camera.Height - 1) / 2.0;
        FirstRay = camera.RayThrough(1.0, 1.0).Direction;
        RayPerColumn = camera.Right / camera.Width;
        RayPerRow = -camera.Up / camera.Height;
    }

    public FrameCamera Camera { get; }

    /// <summary>m, MOON_ME: a point of the vertex lattice, within 2^-7 m of the camera.</summary>
    public Vector3D Origin { get; }

    /// <summary>m, MOON_ME: vector from the origin to the camera.</summary>
    public Vector3D Remainder { get; }

    /// <summary>
    /// m, MOON_ME: the lattice point to which the planes of facets are relative. It is near the camera or, for a camera far away, the
    /// Moon's centre.
    /// </summary>
    public Vector3D Anchor { get; }

    /// <summary>m, MOON_ME: vector from the anchor to the origin, exact.</summary>
    public Vector3D OriginFromAnchor => Origin - Anchor;

    /// <summary>
    /// Component of each pixel's ray direction along the viewing direction: the point at parameter t of a ray has a depth of t times this.
    /// </summary>
    public double Distance { get; }

    /// <summary>Pixels per unit of the tangent of the angle from the viewing direction.</summary>
    public double PixelsPerTangent { get; }

    /// <summary>
    /// The dot product of this with a vector from the camera, divided by the vector's depth, is its column relative to
    /// <see cref="CentreX"/>.
    /// </summary>
    public Vector3D Across { get; }

    /// <summary>
    /// The dot product of this with a vector from the camera, divided by the vector's depth, is its row relative to <see cref="CentreY"/>.
    /// </summary>
    public Vector3D Down { get; }

    /// <summary>Viewing direction, MOON_ME: its dot product with a vector from the camera is the vector's depth.</summary>
    public Vector3D Forward { get; }

    /// <summary>Column that the viewing direction meets, px.</summary>
    public double CentreX { get; }

    /// <summary>Row that the viewing direction meets, px.</summary>
    public double CentreY { get; }

    /// <summary>Ray direction of the pixel in column 0 and row 0.</summary>
    public Vector3D FirstRay { get; }

    /// <summary>Change of the ray direction from one column to the next.</summary>
    public Vector3D RayPerColumn { get; }

    /// <summary>Change of the ray direction from one row to the next.</summary>
    public Vector3D RayPerRow { get; }

    /// <summary>
    /// px: maximum absolute column or row of a projected vertex that is used; edges of vertices beyond it are computed in space.
    /// </summary>
    public double CoordinateLimit { get; }

    /// <summary>
    /// px2: facets whose signed area is above this certainly face away from the camera. It is above the rounding error of products of
    /// coordinates within the limit.
    /// </summary>
    public double BackFaceArea => Math.ScaleB(CoordinateLimit * CoordinateLimit, -50);

    /// <summary>
    /// The view frustum of the image's samples. It is wider by half a pixel and by the rounding error of a projected direction (some 1e-16
    /// rad).
    /// </summary>
    public ViewFrustum Frustum() => _lens is null
        ? new ViewFrustum(Camera, 0.5 + (PixelsPerTangent * 1e-14))
        : ViewFrustum.Of(Camera, _lens.Tangents);

    private Vector3D RayAt(in ImagePlaneMap map, double column, double row)
    {
        (double right, double down) = map.Inverse(column, row);
        return Distance * (Forward + (right * Camera.UnitRight) - (down * Camera.UnitUp));
    }

    private static double OnLattice(double metres) => Math.Round(metres * LatticePoint.StepsPerMetre) / LatticePoint.StepsPerMetre;
}
