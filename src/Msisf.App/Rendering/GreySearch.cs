using System.Globalization;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;

namespace Msisf.App.Rendering;

/// <summary>Finds the exposure of <c>--exposure auto</c>: that of the grey levels, the same for all frames of a run.</summary>
internal static class GreySearch
{
    /// <summary>Part of the lit pixels of all frames that stay below white.</summary>
    private const double KeptShare = 0.995;

    /// <summary>Linear grey (level 159 of sRGB) that half of the lit pixels do not exceed: even ground is not near white.</summary>
    private const double MostOfMedian = 0.35;

    /// <summary>Digits of the exposure, so that machines whose sines differ in the last bit find the same.</summary>
    private const int Digits = 3;

    /// <summary>The settings with the exposure that was found; with that of the law if no pixel is lit.</summary>
    /// <param name="looked">The frames that are looked at.</param>
    public static NativeSettings Resolve(
        RenderSettings settings, IReadOnlyList<Frame> looked, ElevationModel model, SurfaceInputs maps, ProgramHost host,
        CancellationToken cancellation)
    {
        float[] lit = Lit(settings, looked, model, maps, host, cancellation);
        if (lit.Length == 0)
        {
            NativeSettings ofLaw = settings.Native.WithExposure(settings.Native.Grey.Exposure);
            host.Log.Note(Invariant($"{Asked}: no pixel is lit; the exposure is {ofLaw.Grey.Exposure:R}."));
            return ofLaw;
        }

        Array.Sort(lit);
        double exposure = Math.Min(1.0 / lit[(int)(KeptShare * (lit.Length - 1))], MostOfMedian / lit[lit.Length / 2]);
        exposure = double.Parse(
            exposure.ToString(Invariant($"E{Digits - 1}"), CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        host.Log.Note(Invariant($"{Asked}: {exposure:R}, from small images of {looked.Count} {(looked.Count == 1 ? "frame" : "frames")}."));
        return settings.Native.WithExposure(exposure);
    }

    private static string Asked => $"{NativeOptions.Exposure.Name} {NativeOptions.Automatic}";

    /// <summary>I/F of the lit pixels of small images; of a scan that of its first exposure.</summary>
    private static float[] Lit(
        RenderSettings settings, IReadOnlyList<Frame> looked, ElevationModel model, SurfaceInputs maps, ProgramHost host,
        CancellationToken cancellation)
    {
        CameraModel small = ReducedCamera.ModelOf(settings.CameraModel, ReducedCamera.LongerSide);
        NativeSettings plain = settings.Native with
        {
            Render = settings.Native.Render with { KeepGroundTruth = false, Adaptive = null, SubsamplesPerAxis = 1 },
        };
        NativeDrawing drawing = new(plain, model.Grid, maps, new NativeLevels(model.DetailOf(settings.LevelOfDetailError)), host.Times);
        List<float> lit = [];
        using IRunProgress progress = host.Progress.Start("Exposure", looked.Count, settings.Unattended);
        foreach (Frame frame in looked)
        {
            using NativeImage image = drawing.Draw(
                frame with
                {
                    Camera = small.At(frame.Camera.State),
                    Motion = null,
                    Noise = null,
                    Scan = null,
                    Path = null,
                    ExposureFactor = null,
                },
                Environment.ProcessorCount, cancellation);
            foreach (double radianceFactor in image.RadianceFactors)
            {
                if (radianceFactor > 0.0)
                {
                    lit.Add((float)radianceFactor);
                }
            }

            progress.Advance(frame.Name);
        }

        return [.. lit];
    }
}
