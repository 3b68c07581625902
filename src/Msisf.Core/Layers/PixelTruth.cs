using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Core.Layers;

/// <summary>What the layers of one pixel are computed from.</summary>
internal readonly struct PixelTruth
{
    private readonly IGroundTruth _frame;

    public PixelTruth(
        IGroundTruth frame, int? meshPixelsPerDegree, in Ray ray, in SurfaceHit hit, in PixelIllumination light, ImageBrightness brightness)
    {
        _frame = frame;
        MeshPixelsPerDegree = meshPixelsPerDegree;
        LineOfSightMoonMe = ray.Direction;
        Hit = hit;
        Light = light;
        Brightness = brightness;

        // Relative to the camera, so that a lamp at the camera lies exactly on the line of sight, however near the ground is.
        ToLightMoonMe = frame.LightPositionMoonMe - ray.Origin - (hit.RayParameter * ray.Direction);
    }

    public PinholeCamera Camera => _frame.Camera;

    /// <summary>Position of the Sun, or of the lamp that replaces it, m.</summary>
    public Vector3D LightPositionMoonMe => _frame.LightPositionMoonMe;

    /// <summary>
    /// px/deg: resolution of the grid whose cells <see cref="SurfaceHit.Facet"/> counts; null if it is not one of latitude and longitude.
    /// </summary>
    public int? MeshPixelsPerDegree { get; }

    /// <summary>From the camera to the point; its length is the unit of the hit's ray parameter.</summary>
    public Vector3D LineOfSightMoonMe { get; }

    public SurfaceHit Hit { get; }

    public PixelIllumination Light { get; }

    /// <summary>How bright the image is there.</summary>
    public ImageBrightness Brightness { get; }

    /// <summary>m: from the point to the light.</summary>
    public Vector3D ToLightMoonMe { get; }
}
