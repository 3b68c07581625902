using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Layers;

/// <summary>
/// What the layers of one pixel are computed from. What several layers need is computed once, by the first that asks. One object serves
/// pixel after pixel; it is for one thread.
/// </summary>
internal sealed class PixelTruth
{
    private double _lineOfSightLength;
    private double _radius;
    private double _lightDistance;
    private SelenographicPoint? _place;

    /// <summary>Starts with a frame.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="meshPixelsPerDegree">
    /// px/deg: resolution of the grid whose cells the facets count; null if it is not one of latitude and longitude.
    /// </param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public PixelTruth(IGroundTruth frame, int? meshPixelsPerDegree, double referenceRadius)
    {
        ReferenceRadius = referenceRadius;
        Camera = frame.Camera;
        AxisLength = Camera.Direction.Length;
        LightPositionMoonMe = frame.LightPositionMoonMe;
        MeshPixelsPerDegree = meshPixelsPerDegree;
    }

    public PinholeCamera Camera { get; }

    /// <summary>Length of the camera's direction vector: of a ray's component along the optical axis.</summary>
    public double AxisLength { get; }

    /// <summary>Position of the Sun, or of the lamp that replaces it, m.</summary>
    public Vector3D LightPositionMoonMe { get; }

    /// <summary>
    /// px/deg: resolution of the grid whose cells <see cref="SurfaceHit.Facet"/> counts; null if it is not one of latitude and longitude.
    /// </summary>
    public int? MeshPixelsPerDegree { get; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius { get; }

    /// <summary>From the camera to the point; its length is the unit of the hit's ray parameter.</summary>
    public Vector3D LineOfSightMoonMe { get; private set; }

    public SurfaceHit Hit { get; private set; }

    public PixelIllumination Light { get; private set; }

    /// <summary>How bright the image is there.</summary>
    public ImageBrightness Brightness { get; private set; }

    /// <summary>m: from the point to the light.</summary>
    public Vector3D ToLightMoonMe { get; private set; }

    /// <summary>Length of <see cref="LineOfSightMoonMe"/>.</summary>
    public double LineOfSightLength => Known(_lineOfSightLength) ? _lineOfSightLength : _lineOfSightLength = LineOfSightMoonMe.Length;

    /// <summary>m: from the Moon's centre to the point.</summary>
    public double Radius => Known(_radius) ? _radius : _radius = Hit.PointMoonMe.Length;

    /// <summary>From the Moon's centre to the point, length 1.</summary>
    public Vector3D Zenith => Hit.PointMoonMe / Radius;

    /// <summary>m: from the point to the light.</summary>
    public double LightDistance => Known(_lightDistance) ? _lightDistance : _lightDistance = ToLightMoonMe.Length;

    /// <summary>Latitude and longitude of the point.</summary>
    public SelenographicPoint Place => _place ??= SelenographicPoint.Below(Hit.PointMoonMe);

    /// <summary>Goes on to a pixel.</summary>
    public void MoveTo(in Ray ray, in SurfaceHit hit, in PixelIllumination light, ImageBrightness brightness)
    {
        LineOfSightMoonMe = ray.Direction;
        Hit = hit;
        Light = light;
        Brightness = brightness;

        // Relative to the camera, so that a lamp at the camera lies exactly on the line of sight, however near the ground is.
        ToLightMoonMe = LightPositionMoonMe - ray.Origin - (hit.RayParameter * ray.Direction);
        (_lineOfSightLength, _radius, _lightDistance, _place) = (-1.0, -1.0, -1.0, null);
    }

    private static bool Known(double length) => length >= 0.0;
}
