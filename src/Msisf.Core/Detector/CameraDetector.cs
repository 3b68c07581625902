using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Sensitivity;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Core.Detector;

/// <summary>The optics and the detector of one camera, for all frames of a run. Safe for several threads.</summary>
public sealed class CameraDetector
{
    /// <summary>Maximum number of instants for which one frame is drawn; odd.</summary>
    public const int MaxSubExposures = 999;

    /// <summary>Part of the focal length by which a camera is changed for the slope of its throughput.</summary>
    private const double ThroughputStep = 1e-4;

    private readonly DetectorSettings _settings;
    private readonly double _electronsPerSteradian;
    private readonly double[] _throughput;
    private readonly DetectorPass _pass;
    private readonly ConcurrentBag<DetectorImage> _idle = [];
    private readonly Lazy<PointImage> _pointImage;
    private readonly Lazy<WingConvolution>? _wings;

    /// <summary>Prepares a camera.</summary>
    /// <param name="camera">Size and geometry of the images; its states do not matter.</param>
    /// <exception cref="BadInputException">The camera can't be drawn as far beyond its borders as the PSF reaches.</exception>
    public CameraDetector(DetectorSettings settings, ICamera camera, int threads)
    {
        _settings = settings;
        Margin = settings.PointSpread?.Radius ?? 0;
        _pointImage = new Lazy<PointImage>(() => new PointImage(settings.PointSpread));
        _wings = settings.FarWings is { } wings
            ? new Lazy<WingConvolution>(() => new WingConvolution(wings, camera.Width, camera.Height, threads, CancellationToken.None))
            : null;
        _ = WindowOf(camera);
        _electronsPerSteradian = settings.ApertureArea * settings.ExposureTime * settings.Response.ElectronRate(SolarSpectrum.IrradianceAt);
        _throughput = PixelThroughput.Of(camera, settings.IsFlatFielded, threads);
        _pass = new DetectorPass(settings, new FixedPattern(settings, camera.Width, camera.Height, threads));
    }

    /// <summary>px: how far the frame must be drawn beyond the detector's borders.</summary>
    public int Margin { get; }

    /// <summary>The camera with which a frame is drawn: as wide as the detector and its margin.</summary>
    /// <exception cref="BadInputException">The camera can't be drawn as far beyond its borders as the PSF reaches.</exception>
    public ICamera WindowOf(ICamera camera)
    {
        try
        {
            return camera.Window(-Margin, -Margin, camera.Width + (2 * Margin), camera.Height + (2 * Margin));
        }
        catch (BadInputException exception)
        {
            throw new BadInputException(
                $"The PSF takes light from {Margin} px beyond the image's borders, where the camera can't be drawn: {exception.Message}",
                exception);
        }
    }

    /// <summary>
    /// The instants for which a frame, or a row of a rolling shutter, must be drawn so that none of its points jumps by more than the
    /// shutter allows.
    /// </summary>
    /// <param name="middle">
    /// The frame at its own time, drawn with <see cref="WindowOf"/>; with ground truth if there is a motion.
    /// </param>
    /// <exception cref="BadInputException">More than <see cref="MaxSubExposures"/> are needed.</exception>
    public SubExposures SubExposuresOf(NativeFrame middle, CameraMotion motion, int threads, CancellationToken cancellation)
    {
        double span = _settings.ExposureTime;
        if (_settings.Shutter is not Shutter shutter || motion.IsRest)
        {
            return new SubExposures(1, span);
        }

        double pixels = ImageMotion.Greatest(middle, motion, span, MaxSubExposures, threads, cancellation);
        double needed = Math.Max(1.0, Math.Ceiling(pixels / shutter.MaxStep));
        return needed <= MaxSubExposures
            ? new SubExposures((int)needed | 1, span)
            : throw new BadInputException(Invariant(
                $"the image moves by up to {pixels:G3} px while the shutter is open for {span:G3} s; steps of 'motion-step' "
                    + $"{shutter.MaxStep} px would be {needed:G3} sub-exposures, and {MaxSubExposures} is the most. Give the camera file a "
                    + $"larger 'motion-step' or a shorter 'exposure-time', or check the velocities."));
    }

    /// <summary>An image without electrons, for one frame.</summary>
    /// <param name="middle">The frame, drawn with <see cref="WindowOf"/>.</param>
    public DetectorImage Begin(NativeFrame middle)
    {
        if (!_idle.TryTake(out DetectorImage? image))
        {
            return new DetectorImage(middle.Camera.Width - (2 * Margin), middle.Camera.Height - (2 * Margin));
        }

        Array.Clear(image.Electrons);
        return image;
    }

    /// <summary>Collects the electrons of one instant of the exposure.</summary>
    /// <param name="drawn">The frame at that instant, drawn with <see cref="WindowOf"/>, in sunlight.</param>
    /// <param name="weight">Part of the exposure that the instant stands for.</param>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public void Collect(NativeFrame drawn, double weight, DetectorImage image, int threads, CancellationToken cancellation) =>
        Collect(drawn, new PixelRows(0, image.Height), weight, image, threads, cancellation);

    /// <summary>Collects the electrons of one instant in some rows.</summary>
    /// <param name="drawn">These rows at that instant, drawn with <see cref="WindowOf"/>.</param>
    /// <param name="weight">Part of the exposure that the instant stands for.</param>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    internal void Collect(
        NativeFrame drawn, PixelRows rows, double weight, DetectorImage image, int threads, CancellationToken cancellation) => _pass.Expose(
        drawn.RadianceFactorMemory, _throughput, row => PerSteradian(drawn, row - rows.First), _ => weight, rows, image, threads,
        cancellation);

    /// <summary>The image of a point on this detector.</summary>
    internal PointImage PointImage => _pointImage.Value;

    /// <summary>px: how far the image of a point reaches.</summary>
    public int PointReach => _pointImage.Value.Radius;

    /// <summary>Electrons that the whole image of a point gets in an exposure.</summary>
    /// <param name="rate">Electrons per second and m^2 of light that falls on the aperture at right angles.</param>
    /// <param name="camera">Sees the point.</param>
    /// <param name="directionBodyFixed">From the camera to the point, length 1.</param>
    /// <remarks>
    /// A flat aperture at an angle t off the axis takes cos t of the light. An ideal flat-field correction divides by what a pixel takes of
    /// an even scene, its solid angle times cos t, over that of a pixel on the axis.
    /// </remarks>
    internal double PointElectrons(double rate, FrameCamera camera, Vector3D directionBodyFixed)
    {
        double cosine = Vector3D.Dot(camera.ForwardBodyFixed, directionBodyFixed);
        double factor = _settings.IsFlatFielded
            ? 1.0 / (camera.Model.FocalX * camera.Model.FocalY * camera.SolidAngle(directionBodyFixed))
            : cosine;
        return _settings.ApertureArea * _settings.ExposureTime * rate * factor;
    }

    /// <summary>Electrons per second that a detector makes of light, for each m^2.</summary>
    /// <param name="irradiance">W m^-2 nm^-1 at a wavelength in nm.</param>
    public double ElectronRate(Func<double, double> irradiance) => _settings.Response.ElectronRate(irradiance);

    /// <summary>Reads out the image of a frame when all its electrons are collected.</summary>
    /// <param name="time">Time of the frame, UTC; goes into the noise.</param>
    /// <param name="camera">The frame's camera at that time; goes into the noise.</param>
    /// <param name="seed">The noise whatever time and camera are; null for that of the detector's seed, of time and camera.</param>
    /// <param name="threads">Number of threads; the image does not depend on it.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public void Read(
        DetectorImage image, Instant time, ICamera camera, NoiseSeed? seed, int threads, CancellationToken cancellation)
    {
        NoiseSource? noise = seed is { } own ? NoiseSource.OfFrame(own.Number, own.Step)
            : _settings.Seed is ulong number ? NoiseSource.OfFrame(number, FrameNumber.Of(time, camera))
            : null;
        image.Noise = seed;
        image.LeftImage = _wings?.Value.Apply(image.Electrons, threads, cancellation) ?? 0.0;
        _pass.Read(image, noise, threads, cancellation);
    }

    /// <summary>The derivatives of the electrons of an image, from those of its radiance factors.</summary>
    /// <param name="factors">Radiance factors of the frame, drawn with <see cref="WindowOf"/>.</param>
    /// <param name="middle">The frame.</param>
    public SensitivityField ElectronsOf(SensitivityField factors, NativeFrame middle, int threads, CancellationToken cancellation)
    {
        (int width, int height) = (factors.Width - (2 * Margin), factors.Height - (2 * Margin));
        SensitivityField electrons = factors.Map(width, height, plane =>
        {
            DetectorImage image = new(width, height);
            _pass.Expose(
                plane, _throughput, row => PerSteradian(middle, row), _ => 1.0, new PixelRows(0, height), image, threads, cancellation);
            return image.Electrons;
        });

        // A pixel covers another part of the sky if the focal length or the principal point is another.
        FrameCamera camera = (FrameCamera)middle.Camera.Window(Margin, Margin, width, height);
        foreach (Parameter parameter in Parameter.All.Where(
            parameter => parameter.Kind is ParameterKind.FocalLength or ParameterKind.Principal))
        {
            double step = ThroughputStep * camera.Model.FocalX;
            double[] more = ThroughputOf(ChangedCamera.By(camera.Model, parameter, step));
            double[] less = ThroughputOf(ChangedCamera.By(camera.Model, parameter, -step));
            double[] plane = electrons.Of(parameter);
            for (int i = 0; i < plane.Length; i++)
            {
                plane[i] += electrons.Mean[i] * (more[i] - less[i]) / (2.0 * step * _throughput[i]);
            }
        }

        return electrons;

        double[] ThroughputOf(CameraModel model) => PixelThroughput.Of(model.At(camera.State), _settings.IsFlatFielded, threads);
    }

    /// <summary>What an image tells of some parameters, with the noise of this detector; the fixed pattern is known.</summary>
    /// <param name="electrons">The derivatives of its electrons.</param>
    /// <param name="image">The image; saturated pixels tell nothing.</param>
    public FisherInformation InformationOf(SensitivityField electrons, IReadOnlyList<Parameter> parameters, DetectorImage image)
    {
        ReadOnlySpan<float> response = _pass.Response;
        double[] variances = new double[electrons.Mean.Length];
        for (int i = 0; i < variances.Length; i++)
        {
            // The derivatives are those of electrons before the pixel's own response.
            double own = response[i];
            variances[i] = image.Saturated[i] == 0 && own > 0.0
                ? _pass.VarianceOf(electrons.Mean[i], i) / (own * own)
                : double.PositiveInfinity;
        }

        return FisherInformation.Of(parameters, [.. parameters.Select(electrons.Of)], variances);
    }

    /// <summary>Electrons that a pixel of a drawn row, from 0 behind the margin, collects at a radiance factor of 1, a steradian.</summary>
    private double PerSteradian(NativeFrame drawn, int row) => _electronsPerSteradian
        * SpectralBand.RadianceOfUnitIrradiance(drawn.Light.At(drawn.Camera, row + 1 + Margin).PositionBodyFixed.Length);

    /// <summary>Returns an image's memory for later frames; it must not be used after that.</summary>
    public void GiveBack(DetectorImage image) => _idle.Add(image);
}

/// <summary>
/// The instants for which a frame, or a row of a rolling shutter, is drawn to sum up its exposure. They lie in the middle of equal parts of
/// the time in which the shutter is open. Immutable.
/// </summary>
public sealed class SubExposures
{
    private readonly double _exposureTime;

    internal SubExposures(int count, double exposureTime) => (Count, _exposureTime) = (count, exposureTime);

    /// <summary>How many; odd, so that one of them is the middle of the exposure.</summary>
    public int Count { get; }

    /// <summary>Index of the middle.</summary>
    public int Middle => Count / 2;

    /// <summary>Part of the exposure that each of them stands for.</summary>
    public double Weight => 1.0 / Count;

    /// <summary>Seconds after the middle.</summary>
    /// <param name="index">From 0.</param>
    public double TimeOf(int index) => (index - Middle) * _exposureTime / Count;
}
