using Msisf.App.Preparation;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Serving;

/// <summary>Follows single rays of a frame on the surface that it shows. The Sun is a point. Thread-safe.</summary>
/// <param name="tracer">Traces rays on the surface.</param>
/// <param name="firstInventedPart">Facets of this part and of those after it are invented; null of frames without.</param>
internal sealed class FrameTruth(Frame frame, ITerrainTracer tracer, int? firstInventedPart)
{
    /// <summary>m: how far before a point of the surface a ray towards it may end; rounding on the way from the camera is less.</summary>
    private const double SamePoint = 1e-3;

    /// <summary>1: from there on straight down to the surface; above the highest point of the Moon.</summary>
    private const double RadiiOutside = 1.01;

    /// <summary>m: some times the distance of the Sun.</summary>
    private const double MaxHeight = 1e12;

    private const double RightAngle = 90.0; // degrees

    /// <summary>Half a pixel: the image begins at 0.5, since 1 is the middle of the first pixel.</summary>
    private const double HalfPixel = 0.5;

    private readonly ICamera _camera = frame.Camera;

    /// <summary>What a point of the image shows; null if it does not show the Moon.</summary>
    /// <param name="x">Pixels from 1, to the right; need not be whole.</param>
    /// <param name="y">Pixels from 1, down.</param>
    /// <exception cref="BadInputException">The point lies outside the image.</exception>
    public SurfaceReading? At(double x, double y)
    {
        RequireInside(_camera, x, y);
        Ray ray = _camera.RayThrough(x, y);
        if (!tracer.TryTrace(ray, out SurfaceHit hit))
        {
            return null;
        }

        SceneLight light = frame.Light.At(_camera, y);
        bool isDark = light.IsSun && tracer.IsHidden(hit.PointBodyFixed, hit.Facet, light.PositionBodyFixed);
        return SurfaceReading.Of(
            _camera.BandAt(y).Camera, ray, hit, PixelIllumination.At(hit.PointBodyFixed, isDark ? 0.0 : 1.0, light),
            light.PositionBodyFixed,
            firstInventedPart);
    }

    /// <summary>Where a place is seen.</summary>
    /// <param name="latitudeDegrees">Degrees.</param>
    /// <param name="longitudeDegrees">Degrees, east.</param>
    /// <param name="height">m over the reference radius; null for the surface itself.</param>
    /// <exception cref="BadInputException">A number is out of its range.</exception>
    public PixelReading Of(double latitudeDegrees, double longitudeDegrees, double? height)
    {
        if (Math.Abs(height ?? 0.0) > MaxHeight)
        {
            throw new BadInputException(Invariant(
                $"the height {height} m of a point is beyond {MaxHeight} m. Give metres over the sphere."));
        }

        Vector3D point = new SurfacePlace(latitudeDegrees, longitudeDegrees, height ?? 0.0, isOverTerrain: false)
            .ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius);
        SurfaceHit? ground = height is null ? Ground(point) : null;
        point = ground?.PointBodyFixed ?? point;
        bool isInFront = _camera.TryProjectPoint(point, out RenderingPoint seen);
        SceneLight light = frame.Light.At(_camera, seen.Y);
        bool isLit = !light.IsSun || !(ground is { } hit
            ? tracer.IsHidden(point, hit.Facet, light.PositionBodyFixed)
            : tracer.TryTrace(new Ray(point, light.PositionBodyFixed - point), out _));
        if (!isInFront)
        {
            return new PixelReading(null, null, Visible: false, "outside the image", isLit);
        }

        Vector3D eye = _camera.BandAt(seen.Y).Camera.PositionBodyFixed;
        string? hiddenBy = !IsInside(_camera, seen.X, seen.Y) ? "outside the image"
            : !IsHidden(new Ray(eye, point - eye)) ? null
            : Vector3D.Dot(point, point - eye) > 0.0 ? "limb" : "terrain";
        return new PixelReading(seen.X, seen.Y, hiddenBy is null, hiddenBy, isLit);
    }

    /// <summary>How high the ground is at a place, m over the reference radius.</summary>
    /// <exception cref="BadInputException">A number is out of its range.</exception>
    public double HeightAt(double latitudeDegrees, double longitudeDegrees) => Ground(
        new SurfacePlace(latitudeDegrees, longitudeDegrees, 0.0, isOverTerrain: false)
            .ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius)).PointBodyFixed.Length - MoonConstants.ReferenceRadius;

    /// <summary>Says of a reading in shadow how far away what is between it and the light's centre is.</summary>
    /// <param name="reading">What is read.</param>
    /// <param name="y">Row of the image in which it was read.</param>
    public SurfaceReading WithShade(SurfaceReading reading, double y)
    {
        if (reading.Lit == IlluminationState.Shadow.Word() && reading.Incidence >= RightAngle)
        {
            return reading with { ShadedAt = 0.0 };
        }

        Vector3D point = new(reading.Position[0], reading.Position[1], reading.Position[2]);
        Vector3D above = (1.0 + (SamePoint / point.Length)) * point;
        Ray toLight = new(above, frame.Light.At(_camera, y).PositionBodyFixed - above);
        return reading.Lit == IlluminationState.Shadow.Word() && tracer.TryTrace(toLight, out SurfaceHit hit)
            ? reading with { ShadedAt = hit.RayParameter * toLight.Direction.Length }
            : reading;
    }

    /// <summary>Refuses points outside the image.</summary>
    /// <exception cref="BadInputException">The point lies outside.</exception>
    public static void RequireInside(ICamera camera, double x, double y)
    {
        if (!IsInside(camera, x, y))
        {
            throw new BadInputException(Invariant(
                $"the pixel ({x}, {y}) lies outside the image of {camera.Width} x {camera.Height} px, whose first pixel is (1, 1)."));
        }
    }

    private static bool IsInside(ICamera camera, double x, double y) =>
        x > HalfPixel && x < camera.Width + HalfPixel && y > HalfPixel && y < camera.Height + HalfPixel;

    private SurfaceHit Ground(Vector3D point)
    {
        Vector3D direction = point.Normalized();
        return tracer.TryTrace(new Ray(RadiiOutside * MoonConstants.ReferenceRadius * direction, -1.0 * direction), out SurfaceHit hit)
            ? hit
            : throw new InvalidOperationException("The closed surface has no point on a radius.");
    }

    private bool IsHidden(Ray toPoint) => tracer.TryTrace(toPoint, out SurfaceHit hit)
        && hit.RayParameter * toPoint.Direction.Length < toPoint.Direction.Length - SamePoint;
}

/// <summary>Where a point of the surface is seen in an image.</summary>
/// <param name="X">Pixels from 1, to the right; null if the point lies behind the camera.</param>
/// <param name="Y">Pixels from 1, down.</param>
/// <param name="Visible">Whether the image shows the point.</param>
/// <param name="HiddenBy">"limb", "terrain" or "outside the image"; null for a visible point.</param>
/// <param name="Lit">Whether light from the Sun's centre, or the lamp, reaches the point.</param>
internal sealed record PixelReading(double? X, double? Y, bool Visible, string? HiddenBy, bool Lit);
