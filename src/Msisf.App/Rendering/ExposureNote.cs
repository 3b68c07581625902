using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Detector;

namespace Msisf.App.Rendering;

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
            $"Exposure of {NumberSpec.TextOf(settings.ExposureTime)} s: of the lit pixels {saturated} are saturated, {empty} empty (less "
                + $"than one DN of light). {Remedy(_survey.LongestTime())}");
    }

    /// <summary>What the exposure time would have to be.</summary>
    private static string Remedy(double? seconds) => seconds is { } time
        ? $"For {Percent(ExposureSurvey.KeptShare)} of them below full well and highest DN it would have to be {NumberSpec.TextOf(time)} s "
            + $"({NativeOptions.ExposureTime.Name})."
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
