using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Detector;

namespace Msisf.App.Preview;

/// <summary>Tells what numbers a camera's detector will give, from small images of the run's frames.</summary>
internal sealed class SignalPreview : IDisposable
{
    private readonly ReducedCamera _camera;
    private readonly SurfaceInputs _maps;
    private readonly NativeDrawing _drawing;
    private readonly ExposureNote _exposure;

    /// <summary>Reduces the camera.</summary>
    /// <param name="settings">The run's settings, with a detector whose exposure time is known.</param>
    /// <param name="isNoiseChosen">Whether the user chose the noise, which then is there whatever the detector's seed.</param>
    /// <param name="maps">The maps of the surface; disposed with this object.</param>
    public SignalPreview(
        RenderSettings settings, bool isNoiseChosen, ElevationModel model, SurfaceInputs maps, RunTimes times)
    {
        NativeSettings native = settings.Native;
        _camera = ReducedCamera.Of(settings.Camera!.Model, native.Detector!.Settings);
        _exposure = new ExposureNote(_camera.Detector with { Seed = native.Detector.Settings.Seed }, isNoiseChosen);
        NativeSettings reduced = native with
        {
            Detector = native.Detector with { Settings = _camera.Detector },
            Render = native.Render with { KeepGroundTruth = false },
        };
        _maps = maps;
        _drawing = new NativeDrawing(
            reduced, model.Grid, maps, new NativeLevels(model.DetailOf(settings.LevelOfDetailError)), times);
    }

    /// <summary>The levels of a frame; null if nothing in it is lit.</summary>
    public SignalLevels? Of(Frame frame, CancellationToken cancellation)
    {
        Frame small = frame with
        {
            Camera = _camera.Model.At(frame.Camera.State), // of a scan the first exposure
            Motion = null,
            Noise = null,
            Scan = null,
            Path = null,
        };
        using NativeImage image = _drawing.Draw(small, Environment.ProcessorCount, cancellation);
        DetectorImage detected = image.Detected!;
        _exposure.Add(frame.Step, detected, image.RadianceFactors);
        List<int> lit = [];
        for (int i = 0; i < detected.Numbers.Length; i++)
        {
            if (image.RadianceFactors[i] > 0.0)
            {
                lit.Add(detected.Numbers[i]);
            }
        }

        lit.Sort();
        return lit.Count == 0 ? null : new SignalLevels(lit[lit.Count / 2], lit[(int)(0.99 * (lit.Count - 1))]);
    }

    /// <summary>Notes how the exposure suits the frames so far.</summary>
    public void WriteNote(ILog log) => _exposure.Write(log);

    public void Dispose() => _maps.Dispose();
}

/// <summary>The digital numbers that a detector is expected to give for the lit ground of an image.</summary>
/// <param name="Median">DN.</param>
/// <param name="High">DN: 99 % of the lit ground have no more.</param>
internal readonly record struct SignalLevels(int Median, int High);
