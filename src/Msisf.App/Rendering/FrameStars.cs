using Msisf.App.Preparation;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Sky;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>The stars of the frames of one camera. Thread-safe.</summary>
/// <param name="catalogue">All stars.</param>
/// <param name="band">The wavelength of images without a detector.</param>
internal sealed class StarsOfCamera(StarCatalogue catalogue, SpectralBand band)
{
    /// <summary>rad: how far lines and stages of a scan may see beyond the directions of its exposures.</summary>
    private const double ScanReach = 0.01;

    /// <summary>rad/s: faster than any body turns.</summary>
    private const double BodyRate = 1e-4;

    private readonly Lock _gate = new();
    private StarBrightness? _electrons;
    private readonly StarBrightness _ofSunlight = new(
        irradiance => irradiance(band.Nanometres) / SpectralBand.RadianceOfUnitIrradiance(AstronomicalConstants.AstronomicalUnit)
            / band.SolarIrradiance);

    /// <summary>The stars of a frame, whose light a detector collects.</summary>
    /// <param name="tracer">Traces rays through the ground that the frame shows.</param>
    /// <param name="detector">Null for an image of grey levels.</param>
    /// <param name="span">s: in which the frame is exposed.</param>
    public StarLights Of(Frame frame, ITerrainTracer tracer, CameraDetector? detector, double span)
    {
        StarBrightness brightness = _ofSunlight;
        if (detector is not null)
        {
            lock (_gate)
            {
                brightness = _electrons ??= new StarBrightness(detector.ElectronRate);
            }
        }

        double turn = (frame.Motion?.AngularVelocityCamera.Length ?? 0.0) + BodyRate;
        double pixel = frame.Camera.Bands.Max(shown => 1.0 / Math.Min(shown.Camera.Model.FocalX, shown.Camera.Model.FocalY));
        double reach = ScanReach + (turn * span) + (2.0 * ((detector?.PointReach ?? 0) + 1.0) * pixel);
        return new StarLights(new FrameSky(catalogue, frame.Camera, frame.Sky, reach), tracer, brightness);
    }

    /// <summary>What the stars add to the radiance factors of pixels: the mean over a pixel of the light of those in it.</summary>
    public IReadOnlyList<(int Pixel, double Factor)> RadianceFactors(StarsOfFrame stars, IGroundTruth frame)
    {
        List<(int Pixel, double Factor)> added = [];
        foreach (StarView view in stars.Views.Where(view => view.HiddenBy is null))
        {
            (PixelRows rows, FrameCamera camera) = frame.Camera.BandAt(view.Y);
            double sun = frame.Light.At(frame.Camera, view.Y).PositionBodyFixed.Length / AstronomicalConstants.AstronomicalUnit;
            double solidAngle = camera.SolidAngle(camera.RayThrough(view.X, view.Y - rows.First).Direction.Normalized());
            int column = (int)Math.Floor(view.X + 0.5) - 1;
            int row = (int)Math.Floor(view.Y + 0.5) - 1;
            added.Add(((row * frame.Camera.Width) + column, _ofSunlight.Of(view.Star) * sun * sun / solidAngle));
        }

        return added;
    }
}
