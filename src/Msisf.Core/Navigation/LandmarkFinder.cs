using System.Runtime.CompilerServices;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>Finds where an image shows landmarks, and what hides them. Single rays are followed; the Sun is a point. Thread-safe.</summary>
public sealed class LandmarkFinder(IReadOnlyList<Landmark> landmarks)
{
    /// <summary>m: how far before a landmark a ray towards it may end; rounding on the way from the camera is less.</summary>
    private const double SamePoint = 1e-3;

    private readonly ConditionalWeakTable<ITerrain, GroundBelow> _grounds = [];

    /// <summary>The landmarks of a frame.</summary>
    public LandmarksOfFrame Find(ICamera camera, SceneLight light, ITerrain terrain)
    {
        GroundBelow below = _grounds.GetValue(terrain, static shown => new GroundBelow(shown));
        List<LandmarkView> views = [];
        foreach (Landmark landmark in landmarks)
        {
            bool hasGround = below.TryFind(landmark.Direction, out SurfaceHit ground);
            Vector3D point = landmark.Height is null && hasGround
                ? ground.PointBodyFixed
                : (terrain.ReferenceRadius + (landmark.Height ?? 0.0)) * landmark.Direction;
            if (camera.TryProjectPoint(point, out RenderingPoint seen) && IsInside(camera, seen))
            {
                SceneLight source = light.At(camera, seen.Y);
                views.Add(View(camera, landmark, point, seen, below.Tracer, source, hasGround ? ground : null));
            }
        }

        return new LandmarksOfFrame(views, landmarks.Count - views.Count);
    }

    private static LandmarkView View(
        ICamera camera, Landmark landmark, Vector3D point, RenderingPoint seen, TerrainTracer tracer, SceneLight light, SurfaceHit? ground)
    {
        (PixelRows rows, FrameCamera band) = camera.BandAt(seen.Y);
        Vector3D way = point - band.PositionBodyFixed;
        Vector3D toLight = light.PositionBodyFixed - point;
        bool isOnGround = landmark.Height is null && ground is not null;
        bool isDark = isOnGround
            ? tracer.IsHidden(point, ground!.Value.Facet, light.PositionBodyFixed)
            : ground?.PointBodyFixed.Length - SamePoint > point.Length || tracer.TryTrace(new Ray(point, toLight), out _);
        bool isHidden = tracer.TryTrace(new Ray(band.PositionBodyFixed, way), out SurfaceHit before)
            && before.RayParameter * way.Length < way.Length - SamePoint;
        Ray ray = band.RayThrough(seen.X, seen.Y - rows.First);
        return new LandmarkView(landmark, point, seen.X, seen.Y)
        {
            HiddenBy = isHidden ? before.Facet : null,
            IsLit = !light.IsSun || !isDark,
            Incidence = ground is { } below ? Vector3D.AngleBetween(below.NormalBodyFixed, toLight) : null,
            Range = way.Length,
            PixelScale = band.PixelSide(ray, way.Length / ray.Direction.Length),
            Derivatives = PixelDerivatives.At(band, point),
        };
    }

    private static bool IsInside(ICamera camera, RenderingPoint point) =>
        point.X >= 0.5 && point.X <= camera.Width + 0.5 && point.Y >= 0.5 && point.Y <= camera.Height + 0.5;
}
