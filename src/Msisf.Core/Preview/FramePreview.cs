using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Preview;

/// <summary>
/// What an image will show, told from its camera and light without drawing it. The ground is a sphere: the one of LOLA, or for a camera
/// near the ground the one through the ground below it. Slopes and the shadows of mountains are left out.
/// </summary>
/// <param name="SubSpacecraft">The point below the camera.</param>
/// <param name="OffNadir">Angle between the viewing direction and the nadir, rad, [0, pi].</param>
/// <param name="Boresight">The ground in the middle of the image; null if the viewing direction misses the sphere.</param>
/// <param name="Share">How much of the image shows the sphere, and how much of that is lit.</param>
/// <param name="IsBesideMap">
/// Whether the model is a map of a part of the Moon that lies outside the image, though the sphere is in it. There is no boresight and no
/// share then.
/// </param>
public sealed record FramePreview(
    SelenographicPoint SubSpacecraft, double OffNadir, BoresightView? Boresight, SphereShare Share, bool IsBesideMap = false)
{
    /// <summary>px beyond the border of the image in which a map's ground still counts as shown.</summary>
    private const double Margin = 1.0;

    /// <summary>The view of one frame.</summary>
    /// <param name="camera">The camera, which is not below the ground.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="terrain">The model for the ground below a low camera; null to take LOLA's sphere always.</param>
    public static FramePreview Of(PinholeCamera camera, SceneLight light, ITerrain? terrain)
    {
        Vector3D position = camera.PositionMoonMe;
        double radius = RadiusBelow(position, terrain);
        SphereShare share = SphereCoverage.Of(camera, light, radius);
        BoresightView? middle = InTheMiddle(camera, light, radius);
        bool isBesideMap = share.Moon > 0.0 && terrain is ITerrainGrid map and not IGlobalGrid
            && !IsInView(map, camera, middle);
        return new FramePreview(
            SelenographicPoint.Below(position),
            Vector3D.AngleBetween(camera.ForwardMoonMe, -position.Normalized()),
            isBesideMap ? null : middle,
            isBesideMap ? new SphereShare(0.0, Lit: null) : share,
            isBesideMap);
    }

    /// <summary>How many pixels a cell of a model is wide in the middle of the image; null if that shows no ground.</summary>
    /// <param name="resolution">Resolution of the model; the cell is taken from north to south, at the equator or at a map's pole.</param>
    public double? PixelsPerCell(GridResolution resolution) => resolution.MetresPerPixel / Boresight?.MetresPerPixel;

    /// <summary>
    /// Whether a block of a map may be in the image; with a lens, whose image is not told here, yes. Where the map holds the middle of the
    /// image, nothing of it is read.
    /// </summary>
    private static bool IsInView(ITerrainGrid map, PinholeCamera camera, BoresightView? middle)
    {
        SurfaceModel surface = SurfaceModel.Of(map);
        return camera.Model.Lens is not null
            || (middle is { } seen && surface.Parts[0].Mesh.PlaceOf(seen.Point.ToDirectionMoonMe()) is not null)
            || new BlockCuller(surface).Find(new ViewFrustum(camera, Margin), threads: 1, CancellationToken.None).Count > 0;
    }

    private static BoresightView? InTheMiddle(PinholeCamera camera, SceneLight light, double radius)
    {
        if (!new ReferenceSphere(radius).TryFirstHit(new Ray(camera.PositionMoonMe, camera.ForwardMoonMe), out Vector3D point))
        {
            return null;
        }

        double metresPerPixel = (point - camera.PositionMoonMe).Length * camera.PixelTangent;
        return double.IsFinite(metresPerPixel) // a camera may be as far away as numbers reach
            ? new BoresightView(
                SelenographicPoint.Below(point), light.IsSun ? SkyDirection.Of(point, light.PositionMoonMe) : null, metresPerPixel)
            : null;
    }

    /// <summary>
    /// m: radius of the sphere. A camera lower than the mountains may be below LOLA's sphere, and much nearer to the ground than to it.
    /// </summary>
    private static double RadiusBelow(Vector3D position, ITerrain? terrain)
    {
        double reference = terrain?.ReferenceRadius ?? MoonConstants.ReferenceRadius;
        return terrain is not null && position.Length - reference < MoonConstants.MaxRelief
            ? TerrainHeight.RadiusBelow(terrain, position)
            : reference;
    }
}
