using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.TestSupport;
using System.Globalization;
using Xunit;

namespace Msisf.Core.Tests.Detector;

/// <summary>Exposure times for light that is known. All seeds are fixed: a failure is a fault, not chance.</summary>
public sealed class ExposureSurveyTests
{
    private const int Side = 256;

    /// <summary>Relative: bins of 0.05 %, and four digits, the last of which is rounded down.</summary>
    private const double Rounding = 0.0016;

    private static readonly DetectorSettings Plain = new()
    {
        ApertureArea = 1e-4,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(0.5)),
        ExposureTime = 0.5,
        Gain = 2.0,
        ConverterBits = 12,
        Bias = 95.0,
        FullWell = 20000.0,
        Seed = null,
    };

    /// <summary>Light of 1 to 1000 electrons per 0.5 s, as often each: 995 of it is the limit of 99.5 %.</summary>
    [Theory]
    [InlineData(1.0, 12, 20000.0, 3999.5 / 995.0)] // the converter: 4095 - 0.5 - 95 DN of 1 electron
    [InlineData(100.0, 12, 20000.0, 20000.0 / 995.0)] // the full well
    [InlineData(1.0, 8, 20000.0, 159.5 / 995.0)] // fewer bits
    [InlineData(2.0, 16, double.PositiveInfinity, 2.0 * 65439.5 / 995.0)]
    public void LongestTime_EvenSpreadOfLight_KeepsTheShareBelowTheLowerLimit(double gain, int bits, double fullWell, double factor)
    {
        DetectorSettings settings = Plain with { Gain = gain, ConverterBits = bits, FullWell = fullWell };

        double time = Survey(settings, i => 1.0 + (i % 1000)).LongestTime()!.Value;

        Assert.InRange(time / (0.5 * factor), 1.0 - Rounding, 1.0);
        string digits = time.ToString("R", CultureInfo.InvariantCulture).Replace(".", string.Empty, StringComparison.Ordinal);
        Assert.InRange(digits.TrimStart('0').Length, 1, 4);
    }

    /// <summary>Dark pixels of space and shadow don't count, however many there are.</summary>
    [Fact]
    public void LongestTime_FewLitPixels_CountsThemAlone()
    {
        ExposureSurvey survey = new(Plain, isNoiseChosen: false);
        DetectorImage image = Image(i => i < 1000 ? 1000.0 : 5.0); // 5: light that the PSF spreads into the dark

        ExposureShares shares = survey.Add(image, Light(i => i < 1000));

        Assert.Equal(1000, shares.Lit);
        Assert.InRange(survey.LongestTime()!.Value / (0.5 * 7999.0 / 1000.0), 1.0 - Rounding, 1.0);
    }

    [Fact]
    public void LongestTime_DarkCurrentAndSmear_TakeTheirPartOfTheWell()
    {
        DetectorSettings dark = Plain with { Dark = new DarkCurrent { Rate = 500.0 }, Gain = 10.0 };
        DetectorSettings smeared = Plain with { Gain = 10.0, Smear = new Smear { RowTime = 1e-4 } };

        // 1000 electrons of light and 250 of dark current in 0.5 s; 255 other rows of 2000 electrons/s pass for 1e-4 s each: 51 electrons.
        Assert.InRange(Survey(dark, _ => 1000.0).LongestTime()!.Value / (0.5 * 20000.0 / 1250.0), 1.0 - Rounding, 1.0);
        Assert.InRange(Survey(smeared, _ => 1000.0).LongestTime()!.Value / (0.5 * 19949.0 / 1000.0), 1.0 - Rounding, 1.0);
    }

    /// <summary>
    /// Even light is the worst case: without regard to noise half of the pixels would be saturated. The detector itself reads it out.
    /// </summary>
    [Theory]
    [InlineData(3.0, 12, double.PositiveInfinity)]
    [InlineData(100.0, 12, 9000.0)]
    public void LongestTime_WithNoise_SaturatesTheShareThatIsAllowed(double gain, int bits, double fullWell)
    {
        DetectorSettings settings = Plain with
        {
            Gain = gain,
            ConverterBits = bits,
            FullWell = fullWell,
            ReadNoise = 25.0,
            ResponseNonuniformity = 0.01,
            Seed = 5,
            Bias = 20.0,
        };
        double time = Survey(settings, _ => 1000.0).LongestTime()!.Value;
        DetectorSettings exposed = settings with { ExposureTime = time };
        DetectorImage image = Image(_ => 1000.0 * time / 0.5);
        DetectorPass pass = new(exposed, new FixedPattern(exposed, Side, Side, 2));
        pass.Read(image, NoiseSource.OfFrame(5, 1), 2, CancellationToken.None);

        // 328 of 65,536 pixels are allowed; bins and digits shorten the time by up to 0.15 %, a tenth of the noise.
        Assert.InRange(image.Saturated.Count(state => state != 0) / (double)image.Saturated.Length, 0.0030, 0.0056);
    }

    [Fact]
    public void LongestTime_NothingLitOrNoRoom_IsNone()
    {
        ExposureSurvey empty = new(Plain, isNoiseChosen: false);
        empty.Add(Image(_ => 0.0), Light(_ => false));

        Assert.Null(empty.LongestTime());
        Assert.Equal(0, empty.Lit);
        Assert.Null(Survey(Plain with { Bias = 5000.0 }, _ => 100.0).LongestTime());
    }

    [Fact]
    public void Add_CountsSaturatedAndEmptyLitPixels()
    {
        DetectorImage image = Image(i => i % 4 == 0 ? 1.9 : 500.0);
        image.Saturated[1] = 1;
        image.Saturated[3] = 2;
        image.Saturated[5] = 3;
        image.Saturated[0] = 1; // not lit

        ExposureShares shares = new ExposureSurvey(Plain, isNoiseChosen: false).Add(image, Light(i => i is > 0 and < 9));

        Assert.Equal(new ExposureShares(8, 3, 2), shares);
    }

    /// <summary>Abramowitz and Stegun, tables 26.1 and 26.2.</summary>
    [Theory]
    [InlineData(0.0, 0.5)]
    [InlineData(1.0, 0.1586552539)]
    [InlineData(-1.0, 0.8413447461)]
    [InlineData(2.5758293035, 0.005)]
    [InlineData(4.0, 0.00003167124)]
    public void Beyond_OfTheTables_IsRightToSevenDigits(double limit, double expected) =>
        Assert.Equal(expected, NormalTail.Beyond(3.0 * limit, 3.0), 8e-8);

    /// <summary>The noise follows from number and step; the state and the detector's seed have no part in it.</summary>
    [Fact]
    public void Read_NoiseSeed_IsTheSameForAnyState()
    {
        DetectorSettings settings = Plain with { Seed = 3, ReadNoise = 20.0 };
        ICamera here = Camera(2e6);
        ICamera there = Camera(3e6);

        ushort[] first = Read(settings, here, new NoiseSeed(9, 4));

        Assert.Equal(first, Read(settings, there, new NoiseSeed(9, 4)));
        Assert.Equal(first, Read(settings with { Seed = 8 }, here, new NoiseSeed(9, 4)));
        Assert.Equal(first, Read(settings with { Seed = null }, here, new NoiseSeed(9, 4)));
        Assert.All(
            (ushort[][])
            [
                Read(settings, here, new NoiseSeed(9, 5)), Read(settings, here, new NoiseSeed(10, 4)), Read(settings, here, null),
            ],
            other => Assert.True(other.Zip(first).Count(pair => pair.First != pair.Second) > Side * Side / 2));
        Assert.NotEqual(Read(settings, here, null), Read(settings, there, null));
    }

    /// <summary>Fixed pattern and noise are drawn apart: another noise seed leaves the pattern, another detector's seed does not.</summary>
    [Fact]
    public void Read_NoiseSeed_LeavesTheFixedPattern()
    {
        DetectorSettings settings = Plain with { Seed = 3, ResponseNonuniformity = 0.1, ConverterBits = 16 };
        ICamera camera = Camera(2e6);
        double[] Deviations(ulong seed, ulong noise) =>
            [.. Read(settings with { Seed = seed }, camera, new NoiseSeed(noise, 1), 15000.0).Select(number => (double)number)];

        double[] one = Deviations(3, 1);

        Assert.True(Correlation(one, Deviations(3, 2)) > 0.95);
        Assert.InRange(Correlation(one, Deviations(4, 1)), -0.05, 0.1);
    }

    private static double Correlation(double[] a, double[] b) => MathNet.Numerics.Statistics.Correlation.Pearson(a, b);

    private static ushort[] Read(DetectorSettings settings, ICamera camera, NoiseSeed? noise, double electrons = 3000.0)
    {
        DetectorImage image = Image(_ => electrons);
        new CameraDetector(settings, camera, threads: 2)
            .Read(image, Moments.OfMjd(55289.0), camera, noise, threads: 2, CancellationToken.None);
        return image.Numbers;
    }

    private static FrameCamera Camera(double distance) =>
        CameraModel.FromFieldOfView(0.5, Side, Side).At(new CameraState(new Vector3D(distance, 0.0, 0.0), UnitQuaternion.Identity));

    private static ExposureSurvey Survey(DetectorSettings settings, Func<int, double> electrons)
    {
        ExposureSurvey survey = new(settings, isNoiseChosen: false);
        survey.Add(Image(electrons), Light(_ => true));
        return survey;
    }

    private static DetectorImage Image(Func<int, double> electrons)
    {
        DetectorImage image = new(Side, Side);
        for (int i = 0; i < image.Electrons.Length; i++)
        {
            image.Electrons[i] = electrons(i);
        }

        return image;
    }

    private static double[] Light(Func<int, bool> isLit) => [.. Enumerable.Range(0, Side * Side).Select(i => isLit(i) ? 0.1 : 0.0)];
}
