using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Scene;

namespace Msisf.App.Rendering;

/// <summary>
/// Finds the exposure time of <c>--exposure-time auto</c>, or the exposure of <c>--exposure auto</c>, from frames spread over the whole
/// run, whichever of its frames a call makes, so that pieces and restarts find the same.
/// </summary>
internal static class ExposureSearch
{
    /// <summary>Number of frames that are looked at; all of a run that has no more.</summary>
    private const int Samples = 32;

    /// <summary>The settings with the exposure time that was found; the same settings if none is to be found.</summary>
    /// <param name="states">The states of the whole run.</param>
    /// <param name="frames">The frames to make; their cameras are checked for the time in which the shutter is open.</param>
    /// <exception cref="BadInputException">There is no such time, or a camera lies below the terrain.</exception>
    public static RenderSettings Resolve(
        RenderSettings settings, IReadOnlyList<SpacecraftState> states, IReadOnlyList<Frame> frames, ElevationModel model,
        SurfaceInputs maps, Func<IEphemeris> sun, ProgramHost host, CancellationToken cancellation)
    {
        if (settings.Native.FindsExposure)
        {
            Frame[] seen = Looked(settings, states, sun, cancellation);
            return settings with { Native = GreySearch.Resolve(settings, seen, model, maps, host, cancellation) };
        }

        if (!settings.Native.FindsExposureTime)
        {
            return settings;
        }

        ResourceCheck.Check(
            [(settings, 1)], atOnce: 1, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes, diskThere: long.MaxValue);
        Frame[] looked = Looked(settings, states, sun, cancellation);
        GroundCheck.Refuse(looked, model, span: 0.0, cancellation, settings.Body);
        double seconds = Find(settings, looked, model, maps, host, cancellation);
        host.Log.Note(Invariant(
            $"{NativeOptions.ExposureTime.Name} {NativeOptions.Automatic}: {seconds:R} s, from {looked.Length} of {states.Count} "
                + $"{(states.Count == 1 ? "frame" : "frames")} of the run."));
        RenderSettings found = settings with { Native = settings.Native.WithExposureTime(seconds) };
        GroundCheck.Refuse(frames, model, found.ShutterSpan, cancellation, settings.Body);
        return found;
    }

    private static Frame[] Looked(
        RenderSettings settings, IReadOnlyList<SpacecraftState> states, Func<IEphemeris> sun, CancellationToken cancellation)
    {
        RenderSettings sampled = settings with { Frames = StepRanges.Of(StepsOf(states.Count)) };
        string[] names = [.. states.Select((_, index) => Invariant($"step {index + 1}"))];
        return FrameSetup.Of(states, names, sampled, new SunPositions(sun, settings.Aberration), cancellation);
    }

    /// <summary>Steps at equal distances, the first and the last among them.</summary>
    private static IEnumerable<int> StepsOf(int count) => count <= Samples
        ? Enumerable.Range(1, count)
        : Enumerable.Range(0, Samples).Select(sample => 1 + (int)((long)sample * (count - 1) / (Samples - 1)));

    private static double Find(
        RenderSettings settings, Frame[] looked, ElevationModel model, SurfaceInputs maps, ProgramHost host,
        CancellationToken cancellation)
    {
        DetectorSettings detector = settings.Native.Detector!.Settings;
        ExposureSurvey survey = new(detector, isNoiseChosen: looked[0].Noise is not null);
        NativeSettings still = settings.Native with
        {
            Detector = settings.Native.Detector with { Settings = detector with { Seed = null, Shutter = null } },
            Render = settings.Native.Render with { KeepGroundTruth = false },
        };
        NativeDrawing drawing = new(still, model.Grid, maps, new NativeLevels(model.DetailOf(settings.LevelOfDetailError)), host.Times);
        using IRunProgress progress = host.Progress.Start("Exposure", looked.Length, settings.Unattended);
        foreach (Frame frame in looked)
        {
            using NativeImage image = drawing.Draw(
                frame with { Motion = null, Noise = null }, Environment.ProcessorCount, cancellation);
            survey.Add(image.Detected!, image.RadianceFactors);
            progress.Advance(frame.Name);
        }

        return survey.LongestTime() ?? throw new BadInputException(survey.Lit == 0
            ? $"{Asked}: no pixel of the frames that were looked at is lit. Give seconds."
            : $"{Asked}: no time keeps {100.0 * ExposureSurvey.KeptShare} % of the lit pixels below full well and highest DN. Look at "
                + "bias, gain, full well and dark current of the camera file, or give seconds.").About(NativeOptions.ExposureTime);
    }

    private static string Asked => $"{NativeOptions.ExposureTime.Name} {NativeOptions.Automatic}";
}

/// <summary>Watches how the exposure suits the frames of a run, and notes once if it does not. Thread-safe.</summary>
/// <param name="isNoiseChosen">Whether the user chose the noise, which then is there whatever the detector's seed.</param>
internal sealed class ExposureNote(DetectorSettings settings, bool isNoiseChosen)
{
    /// <summary>Parts of the lit pixels of a run from which on it is said that they are saturated or empty.</summary>
    private const double MuchSaturated = 0.01;

    private const double MuchEmpty = 0.1;

    /// <summary>The same of a single frame of a run that is well exposed as a whole.</summary>
    private const double VeryMuchSaturated = 0.1;

    private const double VeryMuchEmpty = 0.5;

    private readonly Lock _gate = new();
    private readonly ExposureSurvey _survey = new(settings, isNoiseChosen);
    private readonly SortedDictionary<int, ExposureShares> _frames = [];

    /// <summary>Takes a frame.</summary>
    /// <param name="image">Its image, read out.</param>
    /// <param name="radianceFactors">I/F of each pixel, 0 in space and in shadow.</param>
    public void Add(int step, DetectorImage image, ReadOnlySpan<double> radianceFactors)
    {
        lock (_gate)
        {
            _frames[step] = _survey.Add(image, radianceFactors);
        }
    }

    /// <summary>Writes the note, if there is something to note.</summary>
    public void Write(ILog log)
    {
        ExposureShares run = _frames.Values.Aggregate(default(ExposureShares), (sum, frame) => sum + frame);
        bool isSaturated = IsNoted(run, Saturated, MuchSaturated, VeryMuchSaturated);
        bool isEmpty = IsNoted(run, Empty, MuchEmpty, VeryMuchEmpty);
        if (!isSaturated && !isEmpty)
        {
            return;
        }

        string saturated = Said(run, Saturated, isSaturated, MuchSaturated);
        string empty = Said(run, Empty, isEmpty, MuchEmpty);
        log.Note(
            $"Exposure of {NumberSpec.TextOf(settings.ExposureTime)} s: {saturated} of the lit pixels are saturated, {empty} are empty "
                + $"(less than one DN of light). {Remedy(_survey.LongestTime())}");
    }

    /// <summary>Which exposure time suits them.</summary>
    private static string Remedy(double? seconds) => seconds is { } time
        ? $"To keep {Percent(ExposureSurvey.KeptShare)} of them below full well and highest DN, use {NativeOptions.ExposureTime.Name} "
            + $"{NumberSpec.TextOf(time)}."
        : "No exposure time keeps them below full well and highest DN: look at bias, gain, full well and dark current.";

    private static double Saturated(ExposureShares frame) => frame.Lit == 0 ? 0.0 : (double)frame.Saturated / frame.Lit;

    private static double Empty(ExposureShares frame) => frame.Lit == 0 ? 0.0 : (double)frame.Empty / frame.Lit;

    private bool IsNoted(ExposureShares run, Func<ExposureShares, double> shareOf, double much, double veryMuch) =>
        shareOf(run) > much || _frames.Values.Any(frame => shareOf(frame) > veryMuch);

    /// <summary>The share of the run; of several frames also the first that has much of it, and the one that has most.</summary>
    private string Said(ExposureShares run, Func<ExposureShares, double> shareOf, bool isNoted, double much)
    {
        string share = Percent(shareOf(run));
        if (!isNoted || _frames.Count == 1)
        {
            return share;
        }

        int first = _frames.First(frame => shareOf(frame.Value) > much).Key;
        (int worst, ExposureShares most) = _frames.MaxBy(frame => shareOf(frame.Value));
        return Invariant($"{share} (first step {first}; worst step {worst}, {Percent(shareOf(most))})");
    }

    private static string Percent(double share) => Invariant($"{100.0 * share:0.#} %");
}
