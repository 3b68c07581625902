using Msisf.Core.Detector.Noise;

namespace Msisf.Core.Detector;

/// <summary>
/// Collects how bright the lit pixels of frames are, and finds the exposure time that suits them. Not thread-safe.
/// </summary>
/// <remarks>
/// A pixel's electrons are r t + s + d t: light r and dark current d grow with the exposure time t, smear s does not. Only lit pixels
/// count. They are sorted by r into bins, each with its mean s. For a time t the expected number of saturated pixels is the sum of their
/// probabilities to be saturated, with the noise that the detector has; the time is found by halving: without noise they jump,
/// so that there is no root for MathNet to find.
/// </remarks>
/// <param name="settings">The detector with which the frames are exposed.</param>
/// <param name="isNoiseChosen">Whether frames have a <see cref="Scene.NoiseSeed"/>, and so noise whatever the detector's seed.</param>
public sealed class ExposureSurvey(DetectorSettings settings, bool isNoiseChosen)
{
    /// <summary>Part of the lit pixels that stay below full well and highest DN in the time that is found.</summary>
    public const double KeptShare = 0.995;

    /// <summary>Bins have 2^-11 of their number as width at most, so that the time found is too short by less than 0.05 %.</summary>
    private const int MantissaBits = 11;

    private const int Shift = 52 - MantissaBits;

    /// <summary>Electrons per second of the first and last bin; what is less or more counts there.</summary>
    private const double Faintest = 1e-12;

    private const double Brightest = 1e18;

    /// <summary>Doublings and halvings of the camera's exposure time among which the time is looked for.</summary>
    private const int MaxDoublings = 200;

    /// <summary>Halvings of the logarithm of a factor of 2: 1e-12 of the time is left.</summary>
    private const int Halvings = 40;

    private static readonly long FirstBin = BinOf(Faintest);

    private readonly long[] _counts = new long[BinOf(Brightest) - FirstBin + 1];
    private readonly double[]? _smear = settings.Smear is null ? null : new double[BinOf(Brightest) - FirstBin + 1];

    /// <summary>Number of lit pixels so far.</summary>
    public long Lit { get; private set; }

    /// <summary>Takes a frame.</summary>
    /// <param name="image">Its image, read out.</param>
    /// <param name="radianceFactors">I/F of each pixel, 0 in space and in shadow.</param>
    public ExposureShares Add(DetectorImage image, ReadOnlySpan<double> radianceFactors)
    {
        ReadOnlySpan<double> smear = SmearOf(image);
        long lit = 0;
        long saturated = 0;
        long empty = 0;
        for (int i = 0; i < radianceFactors.Length; i++)
        {
            if (!(radianceFactors[i] > 0.0))
            {
                continue;
            }

            lit++;
            saturated += image.Saturated[i] == 0 ? 0 : 1;
            empty += image.Electrons[i] < settings.Gain ? 1 : 0;
            double rate = Math.Clamp(image.Electrons[i] / settings.ExposureTime, Faintest, Brightest);
            long bin = BinOf(rate) - FirstBin;
            _counts[bin]++;
            if (_smear is not null)
            {
                _smear[bin] += smear[i];
            }
        }

        Lit += lit;
        return new ExposureShares(lit, saturated, empty);
    }

    /// <summary>
    /// The longest exposure time, s, in which <see cref="KeptShare"/> of the lit pixels stay below full well and highest DN, rounded down
    /// to four digits; null if there is no lit pixel, or if none is short enough.
    /// </summary>
    public double? LongestTime()
    {
        Bin[] bins = [.. Enumerable.Range(0, _counts.Length).Where(bin => _counts[bin] > 0).Select(bin => new Bin(
            BitConverter.Int64BitsToDouble((bin + 1 + FirstBin) << Shift), // its upper end
            _smear is null ? 0.0 : _smear[bin] / _counts[bin],
            _counts[bin]))];
        double allowed = (1.0 - KeptShare) * Lit;
        double shorter = settings.ExposureTime;
        for (int i = 0; bins.Length > 0 && i < MaxDoublings && !IsWithin(shorter); i++)
        {
            shorter *= 0.5;
        }

        for (int i = 0; bins.Length > 0 && i < MaxDoublings && IsWithin(2.0 * shorter); i++)
        {
            shorter *= 2.0;
        }

        if (bins.Length == 0 || !IsWithin(shorter))
        {
            return null;
        }

        double longer = 2.0 * shorter;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = Math.Sqrt(shorter * longer);
            (shorter, longer) = IsWithin(middle) ? (middle, longer) : (shorter, middle);
        }

        return RoundedDown(shorter);

        bool IsWithin(double time) => bins.Sum(bin => bin.Count * Saturation(bin, time)) <= allowed;
    }

    /// <summary>Probability that a pixel of a bin is saturated.</summary>
    private double Saturation(in Bin bin, double time)
    {
        double light = (bin.Rate * time) + bin.Smear;
        double dark = settings.Dark.Rate * settings.Dark.TemperatureFactor * time;
        double highest = (settings.MaxNumber - 0.5 - settings.Bias) * settings.Gain; // the reading is rounded
        if (settings.Seed is null && !isNoiseChosen)
        {
            return light + dark >= Math.Min(highest, settings.FullWell) ? 1.0 : 0.0;
        }

        double pattern = settings.Seed is null ? 0.0 : 1.0;
        double response = pattern * settings.ResponseNonuniformity * light;
        double darkness = pattern * settings.Dark.Nonuniformity * dark;
        double inWell = light + dark + (response * response) + (darkness * darkness);
        double offset = pattern * settings.ColumnOffset * settings.Gain;
        double atConverter = inWell + (settings.ReadNoise * settings.ReadNoise) + (offset * offset);
        return Math.Max(
            NormalTail.Beyond(highest - light - dark, Math.Sqrt(atConverter)),
            NormalTail.Beyond(settings.FullWell - light - dark, Math.Sqrt(inWell)));
    }

    private ReadOnlySpan<double> SmearOf(DetectorImage image)
    {
        if (_smear is null)
        {
            return [];
        }

        double[] smear = new double[image.Electrons.Length];
        SmearSum.Fill(image.Electrons, image.Width, .., settings, smear);
        return smear;
    }

    /// <summary>The first bits of a positive number order numbers by their size.</summary>
    private static long BinOf(double rate) => BitConverter.DoubleToInt64Bits(rate) >> Shift;

    /// <summary>Few digits, so that machines whose sines differ in the last bit find the same.</summary>
    private static double RoundedDown(double time)
    {
        int power = 3 - (int)Math.Floor(Math.Log10(time));
        double scale = Math.Pow(10.0, Math.Abs(power));
        return power >= 0 ? Math.Floor(time * scale) / scale : Math.Floor(time / scale) * scale;
    }

    /// <param name="Rate">Electrons per second.</param>
    /// <param name="Smear">Electrons.</param>
    /// <param name="Count">Pixels.</param>
    private readonly record struct Bin(double Rate, double Smear, long Count);
}

/// <summary>How many pixels of a frame show lit ground, and how many of them the exposure does not suit.</summary>
/// <param name="Lit">Pixels with light of the Sun.</param>
/// <param name="Saturated">Those of them at the highest DN or at the full well.</param>
/// <param name="Empty">Those of them in which light makes less than one DN.</param>
public readonly record struct ExposureShares(long Lit, long Saturated, long Empty)
{
    /// <summary>The counts of two frames together.</summary>
    public static ExposureShares operator +(ExposureShares a, ExposureShares b) =>
        new(a.Lit + b.Lit, a.Saturated + b.Saturated, a.Empty + b.Empty);
}
