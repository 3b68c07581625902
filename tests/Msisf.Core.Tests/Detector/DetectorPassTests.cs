using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Detector.Psf;
using Xunit;

namespace Msisf.Core.Tests.Detector;

/// <summary>The chain on even or simple light. All seeds are fixed: a failure is a fault, not chance.</summary>
public sealed class DetectorPassTests
{
    private const int Side = 512;
    private const double PhotonTransfer = 0.005; // asked: relative error of gain and read noise

    private static readonly DetectorSettings Plain = new()
    {
        ApertureArea = 1e-4,
        Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(0.5)),
        ExposureTime = 0.5,
        Gain = 2.5,
        ConverterBits = 16,
        Bias = 100.0,
        Seed = 11,
    };

    [Fact]
    public void Read_EvenLight_PhotonTransferGivesGainAndReadNoise()
    {
        DetectorSettings settings = Plain with { ReadNoise = 12.0 };
        (double Mean, double Variance)[] points = [.. ((double[])[0.0, 2000.0, 8000.0, 30000.0]).Select(
            (electrons, step) => PairStatistics(settings, electrons, (ulong)(100 + (16 * step))))];

        // Variance = mean / gain + (read noise / gain)^2 + 1/12 of the rounding; the difference of two frames has no fixed pattern.
        double readNoise = settings.Gain * Math.Sqrt(points[0].Variance - (1.0 / 12.0));
        double weighted = points.Skip(1).Sum(point => point.Variance - points[0].Variance);
        double gain = points.Skip(1).Sum(point => point.Mean - points[0].Mean) / weighted;
        Assert.InRange(gain, settings.Gain * (1.0 - PhotonTransfer), settings.Gain * (1.0 + PhotonTransfer));
        Assert.InRange(readNoise, settings.ReadNoise * (1.0 - PhotonTransfer), settings.ReadNoise * (1.0 + PhotonTransfer));
    }

    [Fact]
    public void Read_MeanOfManyFrames_ShowsResponseNonuniformity()
    {
        const double Prnu = 0.02;
        DetectorSettings settings = Plain with { ResponseNonuniformity = Prnu, Seed = 3 };
        FixedPattern pattern = new(settings, Side, Side, 2);
        Assert.Equal(1.0, pattern.Response.Average(one => (double)one), 3);
        Assert.InRange(Deviation(pattern.Response), Prnu * 0.99, Prnu * 1.01);

        double[] mean = MeanOfFrames(settings, pattern, electrons: 40000.0, frames: 8);
        double shot = Math.Sqrt(40000.0 / 8.0) / settings.Gain;
        double expected = Math.Sqrt((Prnu * 16000.0 * Prnu * 16000.0) + (shot * shot) + (1.0 / 96.0));
        Assert.InRange(Deviation(mean), expected * 0.99, expected * 1.01);
    }

    [Fact]
    public void FixedPattern_DarkCurrent_HasItsMeanSpreadAndTemperature()
    {
        DarkCurrent dark = new() { Rate = 80.0, Nonuniformity = 0.4, Temperature = 33.0, DoublingTemperature = 6.5 };
        FixedPattern pattern = new(Plain with { Dark = dark }, Side, Side, 2);
        const double Mean = 80.0 * 4.0 * 0.5; // two doublings, half a second
        Assert.InRange(pattern.DarkElectrons.Average(one => (double)one), Mean * 0.995, Mean * 1.005);
        Assert.InRange(Deviation(pattern.DarkElectrons), Mean * 0.4 * 0.98, Mean * 0.4 * 1.02);
        Assert.True(pattern.DarkElectrons.Min() > 0.0f);
    }

    [Fact]
    public void FixedPattern_Defects_AreWhereTheListSaysAndAsManyAsTheSeed()
    {
        DetectorSettings settings = Plain with
        {
            DeadFraction = 0.01,
            DeadPixels = [new DeadPixel(5, 2)],
            Dark = new DarkCurrent { Rate = 1.0, HotFraction = 0.02, HotRate = 5000.0, HotPixels = [new HotPixel(7, 3, 900.0)] },
        };
        FixedPattern pattern = new(settings, Side, Side, 2);
        Assert.Equal(0.0f, pattern.Response[Side + 4]);
        Assert.Equal(450.0f, pattern.DarkElectrons[(2 * Side) + 6]);
        // some standard deviations of the number of such pixels
        Assert.InRange(pattern.Response.Count(one => one == 0.0f) / (double)pattern.Response.Length, 0.0095, 0.0105);
        Assert.InRange(pattern.DarkElectrons.Count(one => one == 2500.0f) / (double)pattern.Response.Length, 0.0195, 0.0205); // the same
    }

    [Fact]
    public void Read_TwoFrames_AreIndependent()
    {
        DetectorSettings settings = Plain with { ReadNoise = 20.0 };
        double[] first = Numbers(settings, Even(4000.0), 1);
        double[] second = Numbers(settings, Even(4000.0), 2);
        Assert.InRange(Correlation(first, second), -0.01, 0.01); // 5 standard deviations of 512 x 512 independent pairs
        Assert.InRange(Correlation(first.AsSpan(1), first.AsSpan(0, first.Length - 1)), -0.01, 0.01);
    }

    [Fact]
    public void Read_OneAndTwoThreads_GiveTheSameImage()
    {
        DetectorSettings settings = Plain with
        {
            ReadNoise = 9.0,
            ResponseNonuniformity = 0.01,
            ColumnOffset = 2.0,
            Dark = new DarkCurrent { Rate = 50.0, Nonuniformity = 0.2, HotFraction = 0.001, HotRate = 1e5 },
            FullWell = 20000.0,
            IsBlooming = true,
            Smear = new Smear { RowTime = 1e-5 },
            CosmicRays = new CosmicRays { Rate = 500.0 },
            PixelPitch = 1e-5,
            PointSpread = PointSpreadKernel.Of(new GaussianSpread(1.0), 4.0),
        };
        double[] light = [.. Enumerable.Range(0, (Side + 8) * (Side + 8)).Select(i => i % 700 == 0 ? 9e5 : (double)(i % 9000))];
        DetectorImage first = Read(settings, light, 77, threads: 1);
        DetectorImage second = Read(settings, light, 77, threads: 2);
        Assert.Equal(first.Numbers, second.Numbers);
        Assert.Equal(first.Saturated, second.Saturated);
        Assert.Equal(first.Electrons, second.Electrons);
        Assert.Contains(first.Saturated, state => state == 2);
    }

    [Fact]
    public void Read_NoSeed_IsTheRoundedMean()
    {
        DetectorSettings settings = Plain with { Seed = null, ReadNoise = 50.0, ResponseNonuniformity = 0.1, ColumnOffset = 5.0 };
        Assert.All(Numbers(settings, Even(1003.0), 5), number => Assert.Equal(501.0, number)); // 100 + 1003 / 2.5 = 501.2
    }

    [Fact]
    public void Read_MoreThanTheConverterHolds_IsClippedAndMarked()
    {
        DetectorImage image = Read(Plain with { Seed = null, ConverterBits = 8, FullWell = 900.0 }, Even(800.0), 1, threads: 2);
        Assert.All(image.Numbers, number => Assert.Equal(255, number));
        Assert.All(image.Saturated, state => Assert.Equal(1, state));
        image = Read(Plain with { Seed = null, FullWell = 900.0 }, Even(1000.0), 1, threads: 2);
        Assert.All(image.Numbers, number => Assert.Equal(460, number)); // 100 + 900 / 2.5
        Assert.All(image.Saturated, state => Assert.Equal(2, state));
    }

    private static double[] Even(double electrons) => [.. Enumerable.Repeat(electrons, Side * Side)];

    private static (double Mean, double Variance) PairStatistics(DetectorSettings settings, double electrons, ulong frame)
    {
        const int Pairs = 4;
        (double mean, double variance) = (0.0, 0.0);
        for (ulong pair = 0; pair < Pairs; pair++)
        {
            double[] first = Numbers(settings, Even(electrons), frame + (2 * pair));
            double[] second = Numbers(settings, Even(electrons), frame + (2 * pair) + 1);
            mean += 0.5 * (first.Average() + second.Average()) / Pairs;
            double deviation = Deviation(first.Zip(second, (a, b) => a - b));
            variance += 0.5 * deviation * deviation / Pairs;
        }

        return (mean, variance);
    }

    private static double[] MeanOfFrames(DetectorSettings settings, FixedPattern pattern, double electrons, int frames)
    {
        double[] sum = new double[Side * Side];
        for (int frame = 0; frame < frames; frame++)
        {
            DetectorImage image = new(Side, Side);
            Expose(new DetectorPass(settings, pattern), settings, Even(electrons), image, (ulong)frame, threads: 2);
            for (int i = 0; i < sum.Length; i++)
            {
                sum[i] += image.Numbers[i] / (double)frames;
            }
        }

        return sum;
    }

    private static double[] Numbers(DetectorSettings settings, double[] light, ulong frame) =>
        [.. Read(settings, light, frame, threads: 2).Numbers.Select(number => (double)number)];

    private static DetectorImage Read(DetectorSettings settings, double[] light, ulong frame, int threads)
    {
        DetectorImage image = new(Side, Side);
        Expose(new DetectorPass(settings, new FixedPattern(settings, Side, Side, threads)), settings, light, image, frame, threads);
        return image;
    }

    private static void Expose(
        DetectorPass pass, DetectorSettings settings, double[] light, DetectorImage image, ulong frame, int threads)
    {
        double[] throughput = new double[Side * Side];
        Array.Fill(throughput, 1.0);
        pass.Expose(light, throughput, _ => 1.0, _ => 1.0, new PixelRows(0, Side), image, threads, CancellationToken.None);
        Assert.Equal(Side, image.Width);
        Assert.True(settings.Gain > 0.0);
        pass.Read(image, settings.Seed is ulong seed ? NoiseSource.OfFrame(seed, frame) : null, threads, CancellationToken.None);
    }

    private static double Deviation(IEnumerable<float> values) => Deviation(values.Select(value => (double)value));

    private static double Deviation(IEnumerable<double> values)
    {
        double[] all = [.. values];
        double mean = all.Average();
        return Math.Sqrt(all.Sum(value => (value - mean) * (value - mean)) / (all.Length - 1));
    }

    private static double Correlation(ReadOnlySpan<double> first, ReadOnlySpan<double> second) =>
        MathNet.Numerics.Statistics.Correlation.Pearson(first.ToArray(), second.ToArray());
}
