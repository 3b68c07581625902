using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Illumination;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.Core.Tracing;

namespace Msisf.App.DataSets;

/// <summary>Makes the states of a data set from points of the unit cube.</summary>
/// <param name="spec">What the data set asks for.</param>
/// <param name="scene">The terrain.</param>
internal sealed class StateMaker(DataSetSpec spec, ISceneGeometry scene)
{
    /// <summary>The states of one image, or of both of a pair.</summary>
    /// <param name="candidate">Number of the point.</param>
    public DrawnState[] Of(Split split, long candidate, double[] point)
    {
        Dictionary<Quantity, double> drawn = spec.Distributions.ToDictionary(
            entry => entry.Key, entry => entry.Value.Quantile(point[entry.Key.Coordinate]));
        ((double latitude, double longitude), Region region) = split.At(point[0], point[1]);
        Vector3D position = new SurfacePlace(latitude, longitude, drawn[Quantity.Altitude], isOverTerrain: true)
            .ToPositionBodyFixed(scene.GroundRadius, scene.ReferenceRadius);
        Instant time = scene.TimeScale.InstantOfMjd(drawn[Quantity.Time]);
        UnitQuaternion pointing = new CameraPointing
        {
            Kind = BoresightKind.OffNadir,
            OffNadir = double.DegreesToRadians(drawn[Quantity.OffNadir]),
            Azimuth = double.DegreesToRadians(drawn[Quantity.Azimuth]),
            Roll = double.DegreesToRadians(drawn[Quantity.Roll]),
        }.MoonFromCamera(position, time, scene);
        SpacecraftState state = new(time, position, pointing)
        {
            SunPositionBodyFixed = drawn.TryGetValue(Quantity.SunElevation, out double elevation)
                ? SunAt(position, elevation, drawn[Quantity.SunAzimuth])
                : null,
            ExposureFactor = drawn.TryGetValue(Quantity.Exposure, out double factor) ? factor : null,
        };
        DrawnState first = new(split.Name, candidate, region, drawn, state);
        return spec.HasPairs ? [first, first with { State = Moved(state, drawn, point) }] : [first];
    }

    /// <summary>The Sun's place for a direction over the ground below a camera.</summary>
    private Vector3D SunAt(Vector3D positionBodyFixed, double elevationDegrees, double azimuthDegrees)
    {
        LocalFrame below = LocalFrame.At(positionBodyFixed);
        Vector3D direction = below.DirectionOf(double.DegreesToRadians(azimuthDegrees), double.DegreesToRadians(elevationDegrees));
        return (scene.GroundRadius(below.Up) * below.Up) + (AstronomicalConstants.AstronomicalUnit * direction);
    }

    /// <summary>The state of a pair's second image: shifted in any direction, and turned about any axis.</summary>
    private static SpacecraftState Moved(SpacecraftState state, Dictionary<Quantity, double> drawn, double[] point) => state with
    {
        PositionBodyFixed = state.PositionBodyFixed + (drawn[Quantity.Shift] * Direction(point, Quantity.DirectionOfShift)),
        MoonFromCamera = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(
            Direction(point, Quantity.AxisOfTurn), double.DegreesToRadians(drawn[Quantity.Turn])),
    };

    /// <summary>A direction; directions are as many in each solid angle of the same size.</summary>
    private static Vector3D Direction(double[] point, int coordinate)
    {
        double z = (2.0 * point[coordinate]) - 1.0;
        double across = Math.Sqrt((1.0 - z) * (1.0 + z));
        (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * point[coordinate + 1]);
        return new Vector3D(across * cosine, across * sine, z);
    }
}

/// <summary>
/// Tells what an image will show: roughly, from a small one with terrain and shadows, or from each of its pixels. Thread-safe.
/// </summary>
internal sealed class ViewProbe
{
    /// <summary>px: longer side of the small image.</summary>
    private const int LongerSide = 48;

    private readonly CameraModel _camera;
    private readonly NativeDrawing _drawing;
    private readonly NativeLevels _levels;
    private readonly int _subsamplesPerAxis;
    private readonly NativeRenderOptions _ground;

    /// <summary>Prepares the small images.</summary>
    public ViewProbe(RenderSettings settings, ElevationModel model, SurfaceInputs maps, RunTimes times)
    {
        NativeSettings native = settings.Native;
        _subsamplesPerAxis = native.Render.DetailSubsamplesPerAxis;
        _ground = native.Render with { KeepGroundTruth = true, SubsamplesPerAxis = 1, Adaptive = null, Indirect = null };
        NativeSettings small = native with { Detector = null, Layers = null, Navigation = null, Render = _ground };
        _camera = ReducedCamera.ModelOf(settings.CameraModel, LongerSide);
        _levels = new NativeLevels(model.DetailOf(settings.LevelOfDetailError));
        _drawing = new NativeDrawing(small, model.Grid, maps, _levels, times);
    }

    public View Of(Frame frame, CancellationToken cancellation)
    {
        using NativeImage image = _drawing.Draw(
            frame with { Camera = _camera.At(frame.Camera.Bands[0].Camera.State), Motion = null, Noise = null, Flow = null },
            threads: 1,
            cancellation);
        IGroundTruth truth = image.ToRendered(Stream.Null).Truth!;
        List<Vector3D> points = [];
        int lit = 0;
        for (int y = 1; y <= _camera.Height; y++)
        {
            for (int x = 1; x <= _camera.Width; x++)
            {
                if (truth.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
                {
                    points.Add(hit.PointBodyFixed);
                    lit += light.VisibleFraction > 0.0 ? 1 : 0;
                }
            }
        }

        double ground = (double)points.Count / (_camera.Width * _camera.Height);
        return new View(ground, points.Count > 0 ? (double)lit / points.Count : 0.0, points);
    }

    /// <summary>
    /// Whether all ground that an image shows lies in a region: on the surface that is drawn, at the centre of each pixel and of those
    /// around the image, so that what a pixel at its border shows lies in it, too.
    /// </summary>
    public bool ShowsOnly(Frame frame, Region region, CancellationToken cancellation)
    {
        NativeRenderer renderer = _levels.For(frame.Camera, _subsamplesPerAxis);
        ICamera camera = Widened(frame.Camera);
        SceneLight lamp = new(camera.PositionBodyFixed, IsSun: false); // no light is asked for, and this one throws no shadows
        using NativeFrame drawn = renderer.Render(camera, lamp, _ground, threads: 1, cancellation);
        for (int y = 1; y <= camera.Height; y++)
        {
            for (int x = 1; x <= camera.Width; x++)
            {
                if (drawn.TryGet(x, y, out SurfaceHit hit, out _) && !region.Contains(hit.PointBodyFixed))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>The camera with a pixel more on each side; without where a lens does not reach so far.</summary>
    private static ICamera Widened(ICamera camera)
    {
        try
        {
            return camera.Window(-1, -1, camera.Width + 2, camera.Height + 2);
        }
        catch (BadInputException)
        {
            return camera;
        }
    }
}

/// <summary>What an image shows.</summary>
/// <param name="Ground">The part of it that shows ground.</param>
/// <param name="Lit">The part of that ground that gets light.</param>
/// <param name="Points">Points of the ground, m, body-fixed.</param>
internal sealed record View(double Ground, double Lit, IReadOnlyList<Vector3D> Points);
