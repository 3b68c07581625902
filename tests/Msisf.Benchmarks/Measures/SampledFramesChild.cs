using System.Diagnostics;
using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;

namespace Msisf.Benchmarks.Measures;

/// <summary>Draws the frames of a <see cref="SampledFramesJob"/> in this process.</summary>
internal sealed class SampledFramesChild
{
    private const string Auto = "auto:";
    private const int TruthPerAxis = 8;
    private const int White = 65535;
    private const double FineLevels = 257.0; // of 65535 in one of 255

    private static readonly GreyScale Grey = new();
    private static readonly NativeRenderOptions Lambert = new() { Reflectance = new LambertReflectance(PovRayScene.Albedo) };

    private readonly SampledFramesJob _job;
    private readonly Scene _scene;
    private readonly SceneLight _light;
    private readonly DrawnModel _model;

    private SampledFramesChild(SampledFramesJob job, IEphemeris ephemeris, DrawnModel model)
    {
        _job = job;
        _scene = Scenes.Named(job.Scene);
        _light = new SceneLight(ephemeris.SunPositionBodyFixed(_scene.State.Time), IsSun: true);
        _model = model;
    }

    /// <summary>Measures.</summary>
    /// <param name="job">What.</param>
    /// <param name="ephemeris">For the Sun.</param>
    public static IReadOnlyList<SampledFramesResult> Run(SampledFramesJob job, IEphemeris ephemeris)
    {
        using DrawnModel model = DrawnModel.Open(job.Label);
        return new SampledFramesChild(job, ephemeris, model).Measure();
    }

    private List<SampledFramesResult> Measure()
    {
        NativeRenderer finest = RendererFor(AdaptiveSampling.SubsamplesPerAxis);
        double[] truth = Draw(finest, Lambert with { SubsamplesPerAxis = TruthPerAxis }, _job.WarmUpFrames + _job.Frames - 1, out _);
        List<SampledFramesResult> results = [];
        foreach (string samples in _job.Samples)
        {
            NativeRenderOptions options = OptionsOf(samples);
            NativeRenderer renderer = RendererFor(options.DetailSubsamplesPerAxis);
            List<double> seconds = [];
            double[] levels = [];
            for (int frame = 0; frame < _job.WarmUpFrames + _job.Frames; frame++)
            {
                levels = Draw(renderer, options, frame, out double took);
                if (frame >= _job.WarmUpFrames)
                {
                    seconds.Add(took);
                }
            }

            results.Add(new SampledFramesResult(samples, seconds, Rms(levels, truth)));
        }

        return results;
    }

    private static NativeRenderOptions OptionsOf(string samples) => samples.StartsWith(Auto, StringComparison.Ordinal)
        ? Lambert with { Adaptive = new AdaptiveSampling(double.Parse(samples[Auto.Length..], CultureInfo.InvariantCulture), Grey) }
        : Lambert with { SubsamplesPerAxis = (int)Math.Sqrt(int.Parse(samples, CultureInfo.InvariantCulture)) };

    private static double Rms(double[] levels, double[] truth) => Math.Sqrt(levels.Zip(truth, (a, b) => (a - b) * (a - b)).Average());

    private NativeRenderer RendererFor(int subsamplesPerAxis) => new(_model.LevelFor(_scene, subsamplesPerAxis));

    /// <summary>Draws a frame and returns its grey levels of 255.</summary>
    private double[] Draw(NativeRenderer renderer, NativeRenderOptions options, int number, out double seconds)
    {
        long start = Stopwatch.GetTimestamp();
        using NativeFrame frame = renderer.Render(Orbit.CameraOf(_scene, number), _light, options, Environment.ProcessorCount);
        seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        return [.. frame.RadianceFactors.ToArray().Select(factor => Grey.Level(factor, White) / FineLevels)];
    }
}
