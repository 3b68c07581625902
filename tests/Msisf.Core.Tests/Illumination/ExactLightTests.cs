using Msisf.Core.Camera;
using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

/// <summary>Light against rays of the exact tracer, at places and times at which it is hard to tell.</summary>
public sealed class ExactLightTests(HardPlaces hard) : IClassFixture<HardPlaces>
{
    private readonly Random _random = new(18);

    /// <summary>
    /// In maps with --exact and at points: a point Sun is in view exactly when the ray to it is free, a disc exactly when one of the rays
    /// to 2,049 points of its upper edge is. In the long form 20,000 places and times for a point, 10,000 for a disc.
    /// </summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void At_Exact_IsTheTracersAnswerWithoutException(string where, double height)
    {
        (bool, bool, int)[] modes =
        [
            (true, false, TestLength.Of(40, 48)), (true, true, TestLength.Of(40, 48)),
            (false, false, TestLength.Of(4, 24)), (false, true, TestLength.Of(4, 24)),
        ];
        foreach ((bool isPoint, bool isFine, int suns) in modes)
        {
            int seen = 0;
            int count = 0;
            foreach (Case at in CasesOf(where, height, isFine, TestLength.Of(1, 30), suns))
            {
                (PlaceLight light, float[] parts) = LightsOf(at.Survey, at.Suns, isPoint, isExact: true)
                    .At(at.Directions, at.Horizons, at.Place);
                bool[] expected = [.. at.Suns.AsParallel().AsOrdered().Select(sun => IsInView(at.Frame, sun, isPoint))];
                Assert.Equal(expected, parts.Select(part => part > 0.0f));
                Assert.Equal(expected.Count(isLit => isLit), light.LitSteps);
                (seen, count) = (seen + light.LitSteps, count + at.Suns.Length);
            }

            Assert.InRange(seen, 1, count - 1);
        }
    }

    /// <summary>Without rays a wrong answer comes only within the stated error of the horizon.</summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void At_PointSun_IsWrongOnlyWithinTheStatedError(string where, double height)
    {
        foreach (Case at in CasesOf(where, height, isFine: false, TestLength.Of(1, 30), 50))
        {
            (_, float[] parts) = LightsOf(at.Survey, at.Suns, isPoint: true, isExact: false).At(at.Directions, at.Horizons, at.Place);
            double error = double.DegreesToRadians(HorizonSurvey.ErrorDegrees);
            for (int step = 0; step < at.Suns.Length; step++)
            {
                Vector3D local = at.Frame.ToLocal(at.Suns[step] - at.Frame.PositionBodyFixed);
                double elevation = Math.Atan2(local.Z, double.Hypot(local.X, local.Y));
                bool isFree = IsFree(at.Frame, local, elevation);
                if (IsFree(at.Frame, local, elevation + error) == isFree && IsFree(at.Frame, local, elevation - error) == isFree)
                {
                    Assert.Equal(isFree, parts[step] > 0.0f);
                }
            }
        }
    }

    /// <summary>The visible part of the disc against 4,096 rays to equal parts of its area, in maps and at points.</summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void At_Disc_IsThePartOfRays(string where, double height)
    {
        foreach ((bool isFine, double tolerance) in ((bool, double)[])[(false, 0.02), (true, 0.01)])
        {
            foreach (Case at in CasesOf(where, height, isFine, TestLength.Of(1, 30), TestLength.Of(2, 4)))
            {
                (PlaceLight light, float[] parts) = LightsOf(at.Survey, at.Suns, isPoint: false, isExact: isFine)
                    .At(at.Directions, at.Horizons, at.Place);
                Assert.Equal(parts.Average(), light.DiscPart, 1e-6);
                for (int step = 0; step < at.Suns.Length; step++)
                {
                    double free = PartOfRays(at.Frame, at.Suns[step]);
                    Assert.Equal(free, parts[step], tolerance);
                    Assert.True(!isFine || free == 0.0 || parts[step] > 0.0f);
                }
            }
        }
    }

    /// <summary>The horizon across the pole is the mountain on the other side, on another model.</summary>
    [Fact]
    public void Find_MountainBeyondThePole_IsTheHorizon()
    {
        Case at = CasesOf("beyond", 2.0, isFine: false, places: 1, suns: 20).Single();
        foreach (Vector3D sun in at.Suns)
        {
            Vector3D local = at.Frame.ToLocal(sun - at.Frame.PositionBodyFixed);
            double turns = Math.Atan2(local.X, local.Y) / (2.0 * Math.PI);
            double horizon = Math.Atan(at.Tangents[(int)((turns - Math.Floor(turns)) * HorizonSurvey.Columns)]);
            Ray ray = new(at.Frame.PositionBodyFixed, at.Frame.DirectionOf(2.0 * Math.PI * turns, horizon - 2e-4));
            Assert.True(hard.Tracer.TryTrace(ray, out SurfaceHit hit));
            Assert.Equal(0, hit.Facet.Part);
            Assert.InRange((hit.PointBodyFixed - at.Frame.PositionBodyFixed).Length, 150_000.0, 220_000.0);
        }
    }

    private LightSurvey LightsOf(HorizonSurvey survey, Vector3D[] suns, bool isPoint, bool isExact) => new(
        survey, new LightConditions(suns, suns) { IsPoint = isPoint, IsExact = isExact }, hard.Tracer);

    private IEnumerable<Case> CasesOf(string where, double height, bool isFine, int places, int suns)
    {
        Vector3D[] directions = hard.Of(where, places, _random);
        HorizonSurvey survey = new(hard.Terrain, hard.Tracer, directions, isMoon: true) { IsFine = isFine };
        PlaceHorizons horizons = survey.Find(directions, height, threads: 2, advanced: null, CancellationToken.None);
        LightSurvey any = LightsOf(survey, [HardPlaces.SunDistance * Vector3D.UnitX], true, false);
        for (int place = 0; place < places; place++)
        {
            LocalFrame frame = LocalFrame.At(horizons.Radii[place] * directions[place]);
            float[] tangents = any.HorizonOf(horizons, place);
            yield return new Case(
                survey, directions, horizons, place, frame, tangents,
                [.. HardPlaces.Suns(where, frame, tangents, survey, suns, _random)]);
        }
    }

    private bool IsFree(LocalFrame frame, Vector3D local, double elevation) => IsFree(
        frame, frame.DirectionOf(Math.Atan2(local.X, local.Y), elevation));

    private bool IsFree(LocalFrame frame, Vector3D direction) => !hard.Tracer.TryTrace(new Ray(frame.PositionBodyFixed, direction), out _);

    private bool IsInView(LocalFrame frame, Vector3D sun, bool isPoint)
    {
        const int Spaces = 2048;
        (Vector3D toSun, Vector3D right, Vector3D up) = AxesOf(frame, sun);
        return isPoint ? IsFree(frame, toSun) : Enumerable.Range(0, Spaces + 1).Any(point =>
        {
            (double sine, double cosine) = Math.SinCos(Math.PI * point / Spaces);
            return IsFree(frame, toSun + (Math.Tan(HardPlaces.SunRadius) * ((cosine * right) + (sine * up))));
        });
    }

    private double PartOfRays(LocalFrame frame, Vector3D sun)
    {
        int rays = TestLength.Of(1024, 4096);
        (Vector3D toSun, Vector3D right, Vector3D up) = AxesOf(frame, sun);
        return Enumerable.Range(0, rays).AsParallel().Count(ray =>
        {
            double turn = ray * 2.39996322972865332; // the golden angle: even over the disc
            double across = Math.Tan(HardPlaces.SunRadius) * Math.Sqrt((ray + 0.5) / rays);
            return IsFree(frame, toSun + (across * Math.Cos(turn) * right) + (across * Math.Sin(turn) * up));
        }) / (double)rays;
    }

    private static (Vector3D ToSun, Vector3D Right, Vector3D Up) AxesOf(LocalFrame frame, Vector3D sun)
    {
        Vector3D toSun = (sun - frame.PositionBodyFixed).Normalized();
        Vector3D right = Vector3D.Cross(toSun, frame.Up).Normalized();
        return (toSun, right, Vector3D.Cross(right, toSun));
    }

    private sealed record Case(
        HorizonSurvey Survey, Vector3D[] Directions, PlaceHorizons Horizons, int Place, LocalFrame Frame, float[] Tangents,
        Vector3D[] Suns);
}
