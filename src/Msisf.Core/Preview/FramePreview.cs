using Msisf.Core.Camera;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Preview;

/// <summary>
/// What an image will show, found from its camera and light without drawing it. The middle of the image is traced on the terrain. For the
/// rest the ground is a sphere: the one of LOLA, or for a camera near the ground the one through the ground below it. Slopes and the
/// shadows of mountains are left out.
/// </summary>
/// <param name="OffNadir">Angle between the viewing direction and the nadir, rad, [0, pi].</param>
/// <param name="Boresight">The ground in the middle of the image; null if the viewing direction misses it.</param>
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
    /// <param name="tracer">Finds the ground in the middle of the image; null to take that of the sphere.</param>
    public static FramePreview Of(ICamera camera, SceneLight light, ITerrain? terrain, ISurface? tracer = null)
    {
        FrameCamera inMiddle = camera.BandAt(0.5 * (1.0 + camera.Height)).Camera;
        Vector3D position = inMiddle.PositionBodyFixed;
        double radius = RadiusBelow(position, terrain);
        SphereShare share = ShareOf(camera, light, radius);
        BoresightView? middle = InTheMiddle(inMiddle, light, tracer ?? new ReferenceSphere(radius));
        bool isBesideMap = share.Moon > 0.0 && terrain is { IsWholeBody: false } && !IsInView(terrain, camera, middle);
        return new FramePreview(
            SelenographicPoint.Below(position),
            Vector3D.AngleBetween(inMiddle.ForwardBodyFixed, -position.Normalized()),
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
    private static bool IsInView(ITerrain map, ICamera camera, BoresightView? middle)
    {
        SurfaceModel surface = SurfaceModel.Of(map);
        return camera.Bands[0].Camera.Model.Lens is not null
            || (middle is { } seen && surface.Parts.Any(part => part.Mesh.PlaceOf(seen.Point.ToDirectionBodyFixed()) is not null))
            || camera.Bounds(Margin).Any(
                bounds => new BlockCuller(surface).Find(bounds, threads: 1, CancellationToken.None).Count > 0);
    }

    /// <summary>The mean over the bands: of the Moon's share by their rows, of the lit share by what they show of the Moon.</summary>
    private static SphereShare ShareOf(ICamera camera, SceneLight light, double radius)
    {
        if (camera.Bands is [CameraBand only])
        {
            return SphereCoverage.Of(only.Camera, light, radius);
        }

        (double moon, double lit) = (0.0, 0.0);
        foreach ((_, FrameCamera band) in camera.Bands)
        {
            SphereShare share = SphereCoverage.Of(band, light.Of(band.State), radius);
            double part = share.Moon * band.Height / camera.Height;
            (moon, lit) = (moon + part, lit + (part * (share.Lit ?? 0.0)));
        }

        return new SphereShare(Math.Min(1.0, moon), moon > 0.0 ? lit / moon : null);
    }

    private static BoresightView? InTheMiddle(FrameCamera camera, SceneLight light, ISurface ground)
    {
        if (!ground.TryFirstHit(new Ray(camera.PositionBodyFixed, camera.ForwardBodyFixed), out Vector3D point))
        {
            return null;
        }

        double metresPerPixel = (point - camera.PositionBodyFixed).Length * camera.PixelTangent;
        return double.IsFinite(metresPerPixel) // a camera may be as far away as numbers reach
            ? new BoresightView(
                SelenographicPoint.Below(point), light.IsSun ? SkyDirection.Of(point, light.PositionBodyFixed) : null, metresPerPixel)
            : null;
    }

    /// <summary>
    /// m: radius of the sphere. A camera lower than the mountains may be below LOLA's sphere, and much nearer to the ground than to it.
    /// </summary>
    private static double RadiusBelow(Vector3D position, ITerrain? terrain)
    {
        double reference = terrain?.ReferenceRadius ?? MoonConstants.ReferenceRadius;
        return terrain is not null && position.Length - reference < MoonConstants.MaxReliefOver(reference)
            ? TerrainHeight.RadiusBelow(terrain, position)
            : reference;
    }
}

/// <summary>The ground in the middle of an image.</summary>
/// <param name="Point">Where the viewing direction meets the terrain, or the sphere.</param>
/// <param name="Sun">Where the Sun is there; null if a lamp lights the scene.</param>
/// <param name="MetresPerPixel">Width that a pixel covers there, m, across the line of sight.</param>
public readonly record struct BoresightView(SelenographicPoint Point, SkyDirection? Sun, double MetresPerPixel);

/// <summary>How much of an image shows a sphere, and how much of that is lit.</summary>
/// <param name="Moon">Part of the image's area that shows the sphere, 0 to 1.</param>
/// <param name="Lit">Part of <paramref name="Moon"/> in which the light is above the horizon, 0 to 1; null if Moon is 0.</param>
public readonly record struct SphereShare(double Moon, double? Lit);
