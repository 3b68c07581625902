using Msisf.Core.Detector.Psf;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Detector.Psf;

public sealed class PointSpreadKernelTests
{
    private const double Cutoff = 7.0; // px
    private const double PixelPart = 1e-6; // the border's pixels are cut by a circle; the integration follows it to that
    private const double EncircledEnergy = 1e-3; // asked

    public static TheoryData<string, double[], double[]> Spreads { get; } = new()
    {
        // tests/reference/point_spread.py: pixels (0, 0), (1, 0), (2, 1); energy within 1, 2, 3 and 5 px
        {
            "gaussian", [0.275571952296, 0.116256873415, 0.00351788753898],
            [0.639552211402, 0.983120115851, 0.999897297435, 0.999999999992]
        },
        {
            "airy", [0.380944625661, 0.101026828233, 0.00539761443824],
            [0.762439600006, 0.888529127588, 0.946444754873, 0.986415878653]
        },
        {
            "wings", [0.0637392374784, 0.0423093910351, 0.0155040599916],
            [0.171655681807, 0.433827241159, 0.629374774477, 0.865754312548]
        },
    };

    [Theory]
    [MemberData(nameof(Spreads))]
    public void Of_Formula_IsItsIntegralOverPixels(string name, double[] pixels, double[] energies)
    {
        PointSpreadKernel kernel = PointSpreadKernel.Of(Spread(name), Cutoff);
        Assert.Equal(15, kernel.Size);
        Assert.InRange(kernel.Weights.ToArray().Sum(), 1.0 - Rounding.OfTurns, 1.0 + Rounding.OfTurns);
        Assert.InRange(At(kernel, 0, 0), pixels[0] - PixelPart, pixels[0] + PixelPart);
        Assert.InRange(At(kernel, 1, 0), pixels[1] - PixelPart, pixels[1] + PixelPart);
        Assert.InRange(At(kernel, -1, -2), pixels[2] - PixelPart, pixels[2] + PixelPart);
        Assert.Equal(4, energies.Length);
    }

    /// <summary>Of pixels 20 times finer, so that what they do to a circle is small beside what is asked.</summary>
    [Theory]
    [MemberData(nameof(Spreads))]
    public void PixelIntegrals_FinePixels_EncircleTheFormulasEnergy(string name, double[] pixels, double[] energies)
    {
        const double Side = 1.0 / 20.0;
        double[] fine = PixelIntegrals.Of(Spread(name), Cutoff, Side);
        int size = (int)Math.Sqrt(fine.Length);
        double[] radii = [1.0, 2.0, 3.0, 5.0];
        for (int i = 0; i < radii.Length; i++)
        {
            double inside = 0.0;
            for (int place = 0; place < fine.Length; place++)
            {
                double distance = Side * double.Hypot((place / size) - (size / 2), (place % size) - (size / 2));
                double covered = Math.Clamp(((radii[i] - distance) / Side) + 0.5, 0.0, 1.0); // of a pixel that the circle cuts
                inside += covered * fine[place];
            }

            Assert.InRange(inside / fine.Sum(), energies[i] - EncircledEnergy, energies[i] + EncircledEnergy);
        }

        Assert.Equal(3, pixels.Length);
    }

    [Fact]
    public void Mix_CoreAndWings_SharesTheLight()
    {
        PointSpreadKernel core = PointSpreadKernel.Of(new GaussianSpread(0.5), 3.0);
        PointSpreadKernel wings = PointSpreadKernel.Of(new WingSpread(1.5, 2.6), Cutoff);
        PointSpreadKernel mixed = PointSpreadKernel.Mix(core, wings, 0.25);
        Assert.Equal(7, mixed.Radius);
        Assert.Equal((0.75 * At(core, 1, 0)) + (0.25 * At(wings, 1, 0)), At(mixed, 1, 0), 15);
        Assert.Equal(0.25 * At(wings, 6, 0), At(mixed, 6, 0), 15);
    }

    [Theory]
    [InlineData(new[] { 1.0, 2.0 }, "square")]
    [InlineData(new[] { 1.0, 2.0, 3.0, 4.0 }, "odd")]
    [InlineData(new[] { 0.0 }, "above 0")]
    [InlineData(new[] { -1.0 }, "-1")]
    [InlineData(new[] { double.NaN }, "NaN")]
    public void Constructor_WrongWeights_SaysWhat(double[] weights, string expected) =>
        Assert.Contains(expected, Assert.Throws<BadInputException>(() => new PointSpreadKernel(weights)).Message, StringComparison.Ordinal);

    private static IRadialSpread Spread(string name) => name switch
    {
        "gaussian" => new GaussianSpread(0.7),
        "airy" => new AirySpread(1.3),
        _ => new WingSpread(1.5, 2.6),
    };

    private static double At(PointSpreadKernel kernel, int x, int y) =>
        kernel.Weights[((kernel.Radius + y) * kernel.Size) + kernel.Radius + x];
}
