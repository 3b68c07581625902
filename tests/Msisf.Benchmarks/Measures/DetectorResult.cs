using System.Diagnostics;
using Msisf.Benchmarks.Definitions;
using Msisf.Core.Detector.Psf;

namespace Msisf.Benchmarks.Measures;

/// <summary>What the detector costs for a frame.</summary>
/// <param name="Spreads">Seconds for a point spread function, by its name.</param>
/// <param name="Noises">Seconds for all noise, by the light.</param>
internal sealed record DetectorResult(
    IReadOnlyList<(string Name, Samples Seconds)> Spreads, IReadOnlyList<(string Name, Samples Seconds)> Noises)
{
    private const double DimElectrons = 20.0; // each pixel's Poisson numbers are inverted one by one
    private const double BrightElectrons = 20000.0;

    /// <summary>Measures.</summary>
    /// <param name="repeats">How often.</param>
    public static DetectorResult Measure(Repeats repeats)
    {
        DetectorChain airy = new(new AirySpread(1.3), BrightElectrons);
        DetectorChain gaussian = new(new GaussianSpread(1.3), BrightElectrons);
        DetectorChain dim = new(new AirySpread(1.3), DimElectrons);
        return new DetectorResult(
            [("Airy", Times(airy.Spread, repeats)), ("Gaussian", Times(gaussian.Spread, repeats))],
            [("up to 20 electrons", Times(dim.Read, repeats)), ("up to 20,000 electrons", Times(airy.Read, repeats))]);
    }

    private static Samples Times(Action action, Repeats repeats)
    {
        for (int i = 0; i < repeats.WarmUpFrames; i++)
        {
            action();
        }

        double[] seconds = new double[repeats.FurtherFrames];
        for (int i = 0; i < seconds.Length; i++)
        {
            long start = Stopwatch.GetTimestamp();
            action();
            seconds[i] = Stopwatch.GetElapsedTime(start).TotalSeconds;
        }

        return new Samples(seconds);
    }
}
