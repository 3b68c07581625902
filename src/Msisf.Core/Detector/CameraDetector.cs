using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Time;

namespace Msisf.Core.Detector;

/// <summary>The optics and the detector of one camera, for all frames of a run. Safe for several threads.</summary>
public sealed class CameraDetector
{
    private readonly DetectorSettings _settings;
    private readonly double _electronsPerSteradian;
    private readonly double[] _throughput;
    private readonly DetectorPass _pass;
    private readonly ConcurrentBag<DetectorImage> _idle = [];

    /// <summary>Prepares a camera.</summary>
    /// <param name="settings">Optics and detector.</param>
    /// <param name="model">Size and geometry of the images.</param>
    /// <param name="threads">Number of threads for the preparation.</param>
    /// <exception cref="BadInputException">The camera can't be drawn as far beyond its borders as the PSF reaches.</exception>
    public CameraDetector(DetectorSettings settings, CameraModel model, int threads)
    {
        _settings = settings;
        Margin = settings.PointSpread?.Radius ?? 0;
        WindowModel = Margin == 0 ? model : Widened(model, Margin);
        _electronsPerSteradian = settings.ApertureArea * settings.ExposureTime * settings.Band.ElectronRate(SolarSpectrum.IrradianceAt);
        _throughput = PixelThroughput.Of(model, settings.IsFlatFielded, threads);
        _pass = new DetectorPass(settings, new FixedPattern(settings, model.Width, model.Height, threads));
    }

    /// <summary>px: how far the frame must be drawn beyond the detector's borders.</summary>
    public int Margin { get; }

    /// <summary>The camera with which frames are drawn: as wide as the detector and its margin.</summary>
    public CameraModel WindowModel { get; }

    /// <summary>Reads out the image of a frame.</summary>
    /// <param name="drawn">The frame, drawn with <see cref="WindowModel"/>, in sunlight.</param>
    /// <param name="time">Time of the frame, UTC; goes into the noise.</param>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <param name="cancellation">Stops the work.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public DetectorImage Expose(NativeFrame drawn, ModifiedJulianDate time, int threads, CancellationToken cancellation)
    {
        if (!_idle.TryTake(out DetectorImage? image))
        {
            image = new DetectorImage(drawn.Camera.Width - (2 * Margin), drawn.Camera.Height - (2 * Margin));
        }

        double perSteradian = _electronsPerSteradian * SpectralBand.RadianceOfUnitIrradiance(drawn.LightPositionMoonMe.Length);
        _pass.Expose(drawn.RadianceFactorMemory, _throughput, perSteradian, image, threads, cancellation);
        _pass.Read(image, FrameNumber.Of(time, drawn.Camera), threads, cancellation);
        return image;
    }

    /// <summary>Returns an image's memory for later frames; it must not be used after that.</summary>
    public void GiveBack(DetectorImage image) => _idle.Add(image);

    private static CameraModel Widened(CameraModel model, int margin)
    {
        try
        {
            return new CameraModel(
                model.Width + (2 * margin),
                model.Height + (2 * margin),
                (model.FocalX, model.FocalY),
                (model.PrincipalX + margin, model.PrincipalY + margin),
                model.Skew,
                model.Distortion).Simplified();
        }
        catch (BadInputException exception)
        {
            throw new BadInputException(
                $"The PSF takes light from {margin} px beyond the image's borders, where the camera can't be drawn: {exception.Message}",
                exception);
        }
    }
}
