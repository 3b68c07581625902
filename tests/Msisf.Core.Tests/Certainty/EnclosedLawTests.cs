using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Certainty;

/// <summary>Enclosures of laws and of their slopes against the laws themselves, at random places of random boxes of angles.</summary>
public sealed class EnclosedLawTests
{
    /// <summary>1: step of the differences.</summary>
    private const double Step = 1e-7;

    /// <summary>Parts of the greatest slope: differences with that step.</summary>
    private const double OfSlopes = 1e-5;

    private const int PlacesOfBox = 20;

    [Theory]
    [InlineData("moon")]
    [InlineData("hapke", "theta", 0.0)]
    [InlineData("hapke", "theta", 45.0)]
    [InlineData("lunar-lambert")]
    [InlineData("lunar-lambert", "l", 0.4)]
    [InlineData("lommel-seeliger")]
    [InlineData("lambert")]
    public void Enclose_RandomBox_HoldsTheLawAndItsSlopes(string name, string? parameter = null, double value = 0.0)
    {
        Dictionary<string, double> parameters = [];
        if (parameter is not null)
        {
            parameters[parameter] = value;
        }

        IReflectance law = ReflectanceFactory.Create(name, parameters);
        Random random = new(51);
        for (int box = 0; box < TestLength.Of(1_000, 300_000); box++)
        {
            (double i, double e, double psi) = (random.NextDouble() * 1.55, random.NextDouble() * 1.55, random.NextDouble() * Math.PI);
            double width = 0.3 * Math.Pow(random.NextDouble(), 4.0);
            double phase = (1.0 - ((Math.Cos(i) * Math.Cos(e)) + (Math.Sin(i) * Math.Sin(e) * Math.Cos(psi)))) / 2.0;
            Interval[] ranges = [Around(Math.Cos(i)), Around(Math.Cos(e)), Around(phase)];
            Sloped found = ((IEnclosedLaw)law).Enclose(
                Sloped.Variable(ranges[0], 0), Sloped.Variable(ranges[1], 1), Sloped.Variable(ranges[2], 2));
            Assert.False(double.IsNaN(found.Value.Low) || double.IsNaN(found.Value.High), $"{ranges[0]} {ranges[1]} {ranges[2]}");
            for (int place = 0; place < PlacesOfBox; place++)
            {
                double[] at = [.. ranges.Select(range => range.Low + (random.NextDouble() * (range.High - range.Low)))];
                if (!IsPossible(at[0], at[1], at[2]))
                {
                    continue;
                }

                double factor = law.RadianceFactor(at[0], at[1], at[2]);
                double rounding = Tolerances.IntervalRounding * found.Value.Magnitude;
                Assert.InRange(factor, found.Value.Low - rounding, found.Value.High + rounding);
                HoldsSlope(law, at, 0, found.First);
                HoldsSlope(law, at, 1, found.Second);
                HoldsSlope(law, at, 2, found.Third);
            }

            Interval Around(double middle) => Interval.Around(middle, width * random.NextDouble()).Clamp(1e-6, 1.0);
        }
    }

    private static void HoldsSlope(IReflectance law, double[] at, int variable, Interval slope)
    {
        (double[] before, double[] after) = ([.. at], [.. at]);
        before[variable] -= Step;
        after[variable] += Step;
        if (!IsPossible(before[0], before[1], before[2]) || !IsPossible(after[0], after[1], after[2])
            || before.Min() <= Step || after.Max() >= 1.0)
        {
            return;
        }

        double greater = law.RadianceFactor(after[0], after[1], after[2]);
        double found = (greater - law.RadianceFactor(before[0], before[1], before[2])) / (2.0 * Step);
        double slack = OfSlopes * Math.Max(1.0, Math.Max(Math.Abs(found), slope.IsFinite ? slope.Magnitude : 0.0));
        Assert.InRange(found, slope.Low - slack, slope.High + slack);
    }

    /// <summary>Whether there is an azimuth with these angles.</summary>
    private static bool IsPossible(double cosIncidence, double cosEmission, double haversine)
    {
        double sines = Math.Sqrt(Math.Max(0.0, (1.0 - (cosIncidence * cosIncidence)) * (1.0 - (cosEmission * cosEmission))));
        double cosine = 1.0 - (2.0 * haversine);
        return Math.Abs(cosine - (cosIncidence * cosEmission)) < sines;
    }
}
