using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public sealed class PoleOrientationTests
{
    private const double Day = 86_400.0;

    /// <summary>The pole is at right ascension alpha and declination delta, the prime meridian at W from the node.</summary>
    [Theory]
    [InlineData(0.0, 90.0, 0.0)]
    [InlineData(281.0, 61.4, 0.0)]
    [InlineData(281.0, 61.4, 200.0)]
    [InlineData(40.0, -30.0, -75.0)]
    public void FrameFromJ2000_PoleAndMeridian_AreWhereTheyAreGiven(double alpha, double delta, double w)
    {
        RotationMatrix frame = Of([alpha], [delta], [w]).FrameFromJ2000(12345.0)!.Value;

        (double sinA, double cosA) = Math.SinCos(double.DegreesToRadians(alpha));
        (double sinD, double cosD) = Math.SinCos(double.DegreesToRadians(delta));
        Vector3D pole = new(cosD * cosA, cosD * sinA, sinD);
        Vector3D node = new(-sinA, cosA, 0.0);
        double angle = double.DegreesToRadians(w);
        Vector3D meridian = (Math.Cos(angle) * node) + (Math.Sin(angle) * Vector3D.Cross(pole, node));
        AssertSame(Vector3D.UnitZ, frame * pole);
        AssertSame(Vector3D.UnitX, frame * meridian);
    }

    /// <summary>W = 10 + 2 d + 0.5 d^2 + 3 sin(20 + 30 T + 40 T^2), alpha with T and a sine, delta with a cosine.</summary>
    [Fact]
    public void FrameFromJ2000_PolynomialsAndPeriodicTerms_AreThoseOfTheTime()
    {
        const double Centuries = 0.25;
        const double Days = 36_525.0 * Centuries;
        PoleOrientation orientation = new()
        {
            RightAscension = new PoleSeries([200.0, -4.0, 8.0], [1.5]),
            Declination = new PoleSeries([50.0, 2.0], [0.0, 0.7]),
            Meridian = new PoleSeries([10.0, 2.0, 5e-7], [3.0]),
            Angles = [[20.0, 30.0, 40.0], [15.0, 60.0, 0.0]],
        };

        double first = double.DegreesToRadians(20.0 + 7.5 + 2.5);
        double second = double.DegreesToRadians(15.0 + 15.0);
        RotationMatrix expected = Of(
            [200.0 - 1.0 + 0.5 + (1.5 * Math.Sin(first))],
            [50.0 + 0.5 + (0.7 * Math.Cos(second))],
            [10.0 + (2.0 * Days) + (5e-7 * Days * Days) + (3.0 * Math.Sin(first))]).FrameFromJ2000(0.0)!.Value;
        RotationMatrix found = orientation.FrameFromJ2000(Days * Day)!.Value;

        AssertSame(expected.Row0, found.Row0);
        AssertSame(expected.Row2, found.Row2);
    }

    /// <summary>The rate is that of the axes: differences over 1 and 2 days, so that both are of the fourth order.</summary>
    [Fact]
    public void RateJ2000_PolynomialsAndPeriodicTerms_IsThatOfTheAxes()
    {
        PoleOrientation orientation = new()
        {
            RightAscension = new PoleSeries([200.0, -4.0, 8.0], [1.5]),
            Declination = new PoleSeries([50.0, 2.0], [0.0, 0.7]),
            Meridian = new PoleSeries([10.0, 0.2, 5e-7], [3.0]),
            Angles = [[20.0, 3000.0, 40.0], [15.0, 60.0, 0.0]],
        };
        const double Time = 9131.25 * Day;

        Vector3D rate = orientation.RateJ2000(Time)!.Value;

        RotationMatrix axes = orientation.FrameFromJ2000(Time)!.Value;
        foreach ((Vector3D axis, Func<RotationMatrix, Vector3D> of) in new (Vector3D, Func<RotationMatrix, Vector3D>)[]
        {
            (axes.Row0, frame => frame.Row0), (axes.Row1, frame => frame.Row1), (axes.Row2, frame => frame.Row2),
        })
        {
            Vector3D near = Difference(of, 0.5 * Day);
            Vector3D expected = near + ((near - Difference(of, Day)) / 3.0);
            Assert.InRange((Vector3D.Cross(rate, axis) - expected).Length, 0.0, 1e-8 * rate.Length); // 1e-4 rad a day to the fourth power
        }

        Vector3D Difference(Func<RotationMatrix, Vector3D> of, double half) =>
            (of(orientation.FrameFromJ2000(Time + half)!.Value) - of(orientation.FrameFromJ2000(Time - half)!.Value)) / (2.0 * half);
    }

    private static PoleOrientation Of(double[] alpha, double[] delta, double[] w) => new()
    {
        RightAscension = new PoleSeries(alpha, []),
        Declination = new PoleSeries(delta, []),
        Meridian = new PoleSeries(w, []),
    };

    private static void AssertSame(Vector3D expected, Vector3D found) => Assert.Equal(0.0, (expected - found).Length, Rounding.OfChains);
}
