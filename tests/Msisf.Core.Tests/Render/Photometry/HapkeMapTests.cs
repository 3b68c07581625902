using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class HapkeMapTests
{
    private const int Width = 12;
    private const int Height = 5;

    [Fact]
    public void FindFactors_SameParametersEverywhere_IsTheLaw()
    {
        SunlitPoints points = Points((0.0, 0.0), (88.0, 200.0), (-33.0, 359.9));
        Map((_, _) => 0.3854).FindFactors(points, new ReferenceGeometry(60.0, 0.0, 60.0));

        HapkeReflectance law = new(SpectralBand.Default.Moon);
        for (int i = 0; i < points.Count; i++)
        {
            Assert.Equal(law.RadianceFactor(0.5, 0.7, 0.2), points.Factors[i], Rounding.OfChains);

            // python3 tests/reference/moon_law.py
            Assert.Equal(0.045825063890022277, points.ReferenceFactors[i], 1e-12);
        }
    }

    [Fact]
    public void FindFactors_BetweenAndBeyondTheGrid_IsLinearAndThenTheNearest()
    {
        // w grows from 0.2 in the first line (60 N) by 0.1 a line of 30 degrees.
        SunlitPoints points = Points((45.0, 100.0), (60.0, 17.0), (89.0, 17.0), (-88.0, 17.0));
        Map((line, _) => 0.2 + (0.1 * line)).FindFactors(points, reference: null);

        Assert.Equal(Factor(0.25), points.Factors[0], Rounding.OfChains);
        Assert.Equal(Factor(0.2), points.Factors[1], Rounding.OfChains);
        Assert.Equal(Factor(0.2), points.Factors[2], Rounding.OfChains);
        Assert.Equal(Factor(0.6), points.Factors[3], Rounding.OfChains);
    }

    [Fact]
    public void FindFactors_AcrossLongitudeZero_IsLinear()
    {
        // Samples at 15, 45, ... 345 degrees: 0 lies between the last and the first.
        SunlitPoints points = Points((0.0, 0.0));
        Map((_, sample) => sample == 0 ? 0.2 : sample == Width - 1 ? 0.4 : 0.9).FindFactors(points, reference: null);

        Assert.Equal(Factor(0.3), points.Factors[0], Rounding.OfChains);
    }

    private static double Factor(double w) => new HapkeReflectance(
        new HapkeParameters(w, 0.2375, 0.3253, 1.686, 0.0672, 23.6566)).RadianceFactor(0.5, 0.7, 0.2);

    private static HapkeMap Map(Func<int, int, double> w)
    {
        double[] others = [0.2375, 0.3253, 1.686, 0.0672, Math.Tan(double.DegreesToRadians(23.6566))];
        double[] first = [.. Enumerable.Range(0, Width * Height).Select(i => w(i / Width, i % Width))];
        return new HapkeMap(
            [first, .. others.Select(value => Enumerable.Repeat(value, Width * Height).ToArray())], Width, northDegrees: 60.0,
                westDegrees: 15.0);
    }

    private static SunlitPoints Points(params (double Latitude, double Longitude)[] places)
    {
        SunlitPoints points = new();
        points.Clear(places.Length);
        foreach ((double latitude, double longitude) in places)
        {
            (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(latitude));
            (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(longitude));
            Vector3D up = new(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
            points.Add(points.Count, 1.0, 1.7374e6 * up, up, 0.5);
            points.CosEmission[points.Count - 1] = 0.7;
            points.PhaseHaversine[points.Count - 1] = 0.2;
        }

        return points;
    }
}
