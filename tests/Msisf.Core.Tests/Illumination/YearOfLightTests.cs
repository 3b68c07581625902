using Msisf.Core.Camera;
using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Illumination;

/// <summary>
/// A year of a map's cell, hour by hour, against what shares nothing with it: rays to a point Sun; and for a disc a horizon that is halved
/// in each azimuth between rays that hit and rays that pass, with the disc summed over its columns.
/// </summary>
public sealed class YearOfLightTests(HardPlaces hard, ITestOutputHelper output) : IClassFixture<HardPlaces>
{
    private const int Hours = 8761;
    private const double Tolerance = 0.001;

    private readonly Random _random = new(31);
    private readonly Vector3D[] _suns = [.. Enumerable.Range(0, Hours).Select(hour => HardPlaces.SunAt(hour / 24.0))];

    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void Of_PointSun_IsLitAsRaysSay(string where, double height)
    {
        int every = TestLength.Of(40, 1);
        Vector3D[] suns = [.. _suns.Where((_, hour) => hour % every == 0)];
        foreach ((LocalFrame frame, PlaceLight light) in Find(where, height, suns, isPoint: true, TestLength.Of(1, 20)))
        {
            int lit = suns.AsParallel().Count(sun => IsFree(frame, sun - frame.PositionBodyFixed));
            Assert.InRange(Math.Abs(lit - light.LitSteps), 0, Math.Max(1.0, Tolerance * suns.Length));
        }
    }

    /// <summary>Every day where the horizon is made of wide facets; in the long form at all kinds, in finer steps of azimuth.</summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void Of_Disc_IsThatOverTheHorizonByRays(string where, double height)
    {
        if (where != "coarse" && !TestLength.IsLong)
        {
            return;
        }

        foreach ((LocalFrame frame, PlaceLight light) in Find(where, height, _suns, isPoint: false, TestLength.Of(1, 4)))
        {
            double[] horizon = HorizonByRays(frame, TestLength.Of(4096, 65_536));
            (double area, bool isAny)[] seen = [.. _suns.Select(sun => PartOver(horizon, frame.ToLocal(sun - frame.PositionBodyFixed)))];
            double lit = seen.Count(part => part.isAny) / (double)Hours;
            double disc = seen.Average(part => part.area);
            output.WriteLine(FormattableString.Invariant(
                $"{where}: lit {lit:F5}, by {light.LitSteps - (lit * Hours):F0} hours off; disc {disc:F5}, by {light.DiscPart - disc:F6}"));
            Assert.Equal(lit, light.LitSteps / (double)Hours, Tolerance);
            Assert.Equal(disc, light.DiscPart, Tolerance);
            Assert.InRange(light.LitSteps, 1, Hours - 1);
        }
    }

    private IEnumerable<(LocalFrame Frame, PlaceLight Light)> Find(
        string where, double height, Vector3D[] suns, bool isPoint, int places)
    {
        Vector3D[] directions = hard.Of(where, places, _random);
        HorizonSurvey survey = new(hard.Terrain, hard.Tracer, directions, isMoon: true);
        PlaceHorizons horizons = survey.Find(directions, height, threads: 2, advanced: null, CancellationToken.None);
        PlaceLight[] lights = new LightSurvey(survey, new LightConditions(suns, suns) { IsPoint = isPoint })
            .Of(directions, horizons, threads: 2, advanced: null, CancellationToken.None);
        return lights.Select((light, place) => (LocalFrame.At(horizons.Radii[place] * directions[place]), light));
    }

    private bool IsFree(LocalFrame frame, Vector3D direction) => !hard.Tracer.TryTrace(new Ray(frame.PositionBodyFixed, direction), out _);

    /// <summary>Elevations, rad, at the middles of equal parts of a turn; higher ones than 35 degrees are not needed.</summary>
    private double[] HorizonByRays(LocalFrame frame, int count)
    {
        const double Limit = 0.61;
        const double Least = 1e-6;
        double[] elevations = new double[count];
        System.Threading.Tasks.Parallel.For(0, 64, part =>
        {
            double before = 0.0;
            for (int i = part * count / 64; i < (part + 1) * count / 64; i++)
            {
                double azimuth = 2.0 * Math.PI * (i + 0.5) / count;
                double step = 5e-4;
                (double low, double high) = (before - step, before + step);
                for (; low > -Limit && IsOpen(low); step *= 3.0)
                {
                    (low, high) = (low - step, low);
                }

                for (; high < Limit && !IsOpen(high); step *= 3.0)
                {
                    (low, high) = (high, high + step);
                }

                while (high - low > Least)
                {
                    double middle = 0.5 * (low + high);
                    (low, high) = IsOpen(middle) ? (low, middle) : (middle, high);
                }

                elevations[i] = before = Math.Clamp(high, -Limit, Limit);

                bool IsOpen(double elevation) => IsFree(frame, frame.DirectionOf(azimuth, elevation));
            }
        });
        return elevations;
    }

    /// <summary>The part of the disc over a horizon, column by column, and whether there is any.</summary>
    private static (double Area, bool IsAny) PartOver(double[] horizon, Vector3D local)
    {
        double azimuth = Math.Atan2(local.X, local.Y);
        double elevation = Math.Atan2(local.Z, double.Hypot(local.X, local.Y));
        double column = 2.0 * Math.PI / horizon.Length;
        double width = HardPlaces.SunRadius / Math.Max(0.01, Math.Cos(elevation));
        (double area, double all, bool isAny) = (0.0, 0.0, false);
        for (int i = (int)Math.Floor((azimuth - width) / column); i <= Math.Ceiling((azimuth + width) / column); i++)
        {
            double across = (((i + 0.5) * column) - azimuth) / width;
            if (Math.Abs(across) < 1.0)
            {
                double half = HardPlaces.SunRadius * Math.Sqrt(1.0 - (across * across));
                double over = horizon[((i % horizon.Length) + horizon.Length) % horizon.Length];
                double visible = Math.Clamp(elevation + half - over, 0.0, 2.0 * half);
                (area, all, isAny) = (area + visible, all + (2.0 * half), isAny || visible > 0.0);
            }
        }

        return (area / all, isAny);
    }
}
