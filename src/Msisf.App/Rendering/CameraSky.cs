using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Sky;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>The sky behind the frames of one camera. Thread-safe.</summary>
/// <param name="inputs">What it is drawn from.</param>
/// <param name="band">The wavelength of images without a detector.</param>
internal sealed class CameraSky(SkyInputs inputs, SpectralBand band)
{
    /// <summary>rad: how far lines and stages of a scan may see beyond the directions of its exposures.</summary>
    private const double ScanReach = 0.01;

    /// <summary>rad/s: faster than any body turns.</summary>
    private const double BodyRate = 1e-4;

    private readonly Lock _gate = new();
    private StarBrightness? _electrons;
    private double _electronsOfSunlight;
    private readonly StarBrightness _ofSunlight = new(
        irradiance => irradiance(band.Nanometres) / SpectralBand.RadianceOfUnitIrradiance(AstronomicalConstants.AstronomicalUnit)
            / band.SolarIrradiance);

    /// <summary>The lights of a frame.</summary>
    /// <param name="tracer">Traces rays through the ground that the frame shows.</param>
    /// <param name="detector">Collects their light; null for an image of grey levels.</param>
    /// <param name="span">s: in which the frame is exposed.</param>
    public FrameLights Of(Frame frame, ITerrainTracer tracer, CameraDetector? detector, double span)
    {
        StarBrightness brightness = _ofSunlight;
        double sunlight = Math.PI;
        if (detector is not null)
        {
            lock (_gate)
            {
                if (_electrons is null)
                {
                    _electrons = new StarBrightness(detector.ElectronRate);
                    _electronsOfSunlight = detector.ElectronRate(SolarSpectrum.IrradianceAt);
                }

                (brightness, sunlight) = (_electrons, _electronsOfSunlight);
            }
        }

        double turn = (frame.Motion?.AngularVelocityCamera.Length ?? 0.0) + BodyRate;
        double pixel = frame.Camera.Bands.Max(shown => 1.0 / Math.Min(shown.Camera.Model.FocalX, shown.Camera.Model.FocalY));
        double reach = ScanReach + (turn * span) + (2.0 * ((detector?.PointReach ?? 0) + 1.0) * pixel);
        return new FrameLights(
            inputs.Stars is { } stars ? new StarLights(new FrameSky(stars, frame.Camera, frame.Sky, reach), tracer, brightness) : null,
            frame.Sky[0].Bodies.Count > 0 ? new BodyLights(frame.Sky, tracer, sunlight) : null,
            frame.Sky);
    }

    /// <summary>Finds what a frame shows of the sky, when all its exposures are collected.</summary>
    /// <param name="lights">The lights of the frame.</param>
    /// <param name="camera">The camera of the frame.</param>
    /// <param name="sun">Where the Sun is, m, body-fixed, at a row.</param>
    /// <param name="hasDetector">Whether a detector has collected their light.</param>
    public SkyOfFrame Find(
        FrameLights lights, ICamera camera, Func<double, Vector3D> sun, bool hasDetector, int threads, CancellationToken cancellation)
    {
        StarsOfFrame? stars = lights.Stars?.Find(camera, hasDetector, threads, cancellation);
        Dictionary<int, double> factors = [];
        BodiesOfFrame? bodies = lights.Bodies?.Find(camera, hasDetector, hasDetector ? null : factors, cancellation);
        foreach (StarView view in hasDetector ? [] : stars?.Views.Where(view => view.IsVisible) ?? [])
        {
            (PixelRows rows, FrameCamera own) = camera.BandAt(view.Y);
            double solidAngle = own.SolidAngle(own.RayThrough(view.X, view.Y - rows.First).Direction.Normalized());
            int column = (int)Math.Floor(view.X + 0.5) - 1;
            int row = (int)Math.Floor(view.Y + 0.5) - 1;
            int pixel = (row * camera.Width) + column;
            factors[pixel] = factors.GetValueOrDefault(pixel) + (_ofSunlight.Of(view.Star) / solidAngle);
        }

        return new SkyOfFrame(stars, bodies, [.. factors.OrderBy(pair => pair.Key).Select(pair =>
        {
            double distance = sun((pair.Key / camera.Width) + 1).Length / AstronomicalConstants.AstronomicalUnit;
            return (pair.Key, pair.Value * distance * distance);
        })])
        {
            Axes = lights.Axes,
        };
    }
}

/// <summary>The lights of the sky in one frame.</summary>
/// <param name="Stars">Null for none.</param>
/// <param name="Bodies">Null for none.</param>
/// <param name="Axes">How the sky lies, for each band of the frame's camera.</param>
internal sealed record FrameLights(StarLights? Stars, BodyLights? Bodies, IReadOnlyList<SkyAxes> Axes) : IPointLights
{
    public void Collect(PointExposure exposure, CameraDetector detector, DetectorImage image, CancellationToken cancellation)
    {
        Stars?.Collect(exposure, detector, image, cancellation);
        Bodies?.Collect(exposure, detector, image, cancellation);
    }
}
