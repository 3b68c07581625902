using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class PixelMeanKernelTests
{
    private const int Pixels = 9;
    private const double Rounding = 1e-9; // m: some dozen operations on heights of km

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(6)]
    [InlineData(16)]
    [InlineData(256)]
    public void At_EvenCount_KeepsTheMeanOfEveryPixel(int samplesPerPixel)
    {
        double[] means = [.. Enumerable.Range(0, Pixels + 6).Select(i => ((i * 7919) % 101 * 60.0) - 3000.0)];
        double[] samples = Interpolate(samplesPerPixel, means);
        for (int pixel = 0; pixel < Pixels; pixel++)
        {
            Assert.Equal(means[pixel + 3], samples.Skip(pixel * samplesPerPixel).Take(samplesPerPixel).Average(), Rounding);
        }
    }

    [Fact]
    public void At_Parabola_IsReproduced()
    {
        const int N = 8;

        // The mean of x^2 over the N midpoints of the pixel around c is c^2 + (1 - 1/N^2) / 12.
        double[] means = [.. Enumerable.Range(-3, Pixels + 6).Select(c => (c * c) + ((1.0 - (1.0 / (N * N))) / 12.0))];
        double[] samples = Interpolate(N, means);
        for (int i = 0; i < samples.Length; i++)
        {
            double x = ((i + 0.5) / N) - 0.5;
            Assert.Equal(x * x, samples[i], Rounding);
        }
    }

    [Fact]
    public void At_StepOfTheMeans_HasASlopeWithoutJumps()
    {
        const int N = 256;
        double[] means = [.. Enumerable.Range(0, Pixels + 6).Select(i => i < 7 ? 0.0 : 1000.0)];
        double[] samples = Interpolate(N, means);
        for (int i = 2; i < samples.Length; i++)
        {
            // The largest curvature of the spline is some thousand m per pixel squared; a jump of the slope would be N times this.
            double bend = samples[i] - (2.0 * samples[i - 1]) + samples[i - 2];
            Assert.InRange(Math.Abs(bend), 0.0, 20_000.0 / (N * N));
        }
    }

    private static double[] Interpolate(int samplesPerPixel, double[] means)
    {
        PixelMeanKernel kernel = new(samplesPerPixel);
        double[] coefficients = new double[PixelMeanKernel.CoefficientCount(Pixels)];
        kernel.Coefficients(means, coefficients, Pixels, step: 1);
        double[] samples = new double[Pixels * samplesPerPixel];
        for (int i = 0; i < samples.Length; i++)
        {
            (int first, double w0, double w1, double w2) = kernel.At(i / samplesPerPixel, i % samplesPerPixel);
            samples[i] = (w0 * coefficients[first]) + (w1 * coefficients[first + 1]) + (w2 * coefficients[first + 2]);
        }

        return samples;
    }
}
