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
        foreach ((bool isPoint, int suns) in ((bool, int)[])[(true, TestLength.Of(40, 48)), (false, TestLength.Of(4, 24))])
        {
            int seen = 0;
            int count = 0;
            foreach (Case at in CasesOf(where, height, TestLength.Of(1, 30), suns))
            {
                bool[] expected = [.. at.Suns.AsParallel().AsOrdered().Select(sun => IsInView(at.Frame, sun, isPoint))];
                foreach (HorizonsOf from in (HorizonsOf[])[at.Kept, at.Fine])
                {
                    (PlaceLight light, float[] parts) = LightsOf(from.Survey, at.Suns, isPoint, isExact: true)
                        .At(at.Directions, from.Horizons, at.Place);
                    Assert.Equal(expected, parts.Select(part => part > 0.0f));
                    Assert.Equal(expected.Count(isLit => isLit), light.LitSteps);
                }

                (seen, count) = (seen + expected.Count(isLit => isLit), count + at.Suns.Length);
            }

            Assert.InRange(seen, 1, count - 1);
        }
    }

    /// <summary>Without rays a wrong answer comes only within the stated error of the horizon.</summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void At_PointSun_IsWrongOnlyWithinTheStatedError(string where, double height)
    {
        foreach (Case at in CasesOf(where, height, TestLength.Of(1, 30), 50))
        {
            (_, float[] parts) = LightsOf(at.Kept.Survey, at.Suns, isPoint: true, isExact: false)
                .At(at.Directions, at.Kept.Horizons, at.Place);
            double error = double.DegreesToRadians(HorizonSurvey.ErrorDegrees);
            int compared = 0;
            for (int step = 0; step < at.Suns.Length; step++)
            {
                Vector3D local = at.Frame.ToLocal(at.Suns[step] - at.Frame.PositionBodyFixed);
                double elevation = Math.Atan2(local.Z, double.Hypot(local.X, local.Y));
                bool isFree = IsFree(at.Frame, local, elevation);
                if (IsFree(at.Frame, local, elevation + error) == isFree && IsFree(at.Frame, local, elevation - error) == isFree)
                {
                    Assert.Equal(isFree, parts[step] > 0.0f);
                    compared++;
                }
            }

            Assert.InRange(compared, at.Suns.Length / 4, at.Suns.Length); // half of the Suns are within 0.02 degrees of the horizon
        }
    }

    /// <summary>The visible part of the disc against 4,096 rays to equal parts of its area, in maps and at points.</summary>
    [Theory]
    [MemberData(nameof(HardPlaces.Kinds), MemberType = typeof(HardPlaces))]
    public void At_Disc_IsThePartOfRays(string where, double height)
    {
        foreach (Case at in CasesOf(where, height, TestLength.Of(1, 30), TestLength.Of(2, 4)))
        {
            double[] free = [.. at.Suns.Select(sun => PartOfRays(at.Frame, sun))];
            foreach ((HorizonsOf from, double tolerance) in ((HorizonsOf, double)[])[(at.Kept, 0.02), (at.Fine, 0.01)])
            {
                (PlaceLight light, float[] parts) = LightsOf(from.Survey, at.Suns, isPoint: false, isExact: from.Survey.IsFine)
                    .At(at.Directions, from.Horizons, at.Place);
                Assert.Equal(parts.Average(), light.DiscPart, 1e-6);
                for (int step = 0; step < at.Suns.Length; step++)
                {
                    Assert.Equal(free[step], parts[step], tolerance);
                    Assert.True(!from.Survey.IsFine || free[step] == 0.0 || parts[step] > 0.0f);
                }
            }
        }
    }

    /// <summary>The horizon across the pole is the mountain on the other side, on another model.</summary>
    [Fact]
    public void Find_MountainBeyondThePole_IsTheHorizon()
    {
        Case at = CasesOf("beyond", 2.0, places: 1, suns: 20).Single();
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

    private static LightSurvey LightsOf(HorizonSurvey survey, Vector3D[] suns, bool isPoint, bool isExact) =>
        new(survey, new LightConditions(suns, suns) { IsPoint = isPoint, IsExact = isExact });

    private IEnumerable<Case> CasesOf(string where, double height, int places, int suns)
    {
        Vector3D[] directions = hard.Of(where, places, _random);
        (HorizonsOf kept, HorizonsOf fine) = (Find(isFine: false), Find(isFine: true));
        for (int place = 0; place < places; place++)
        {
            LocalFrame frame = LocalFrame.At(kept.Horizons.Radii[place] * directions[place]);
            float[] tangents = kept.Survey.HorizonOf(kept.Horizons, place);
            yield return new Case(
                directions, kept, fine, place, frame, tangents,
                [.. HardPlaces.Suns(where, frame, tangents, kept.Survey, suns, _random)]);
        }

        HorizonsOf Find(bool isFine)
        {
            HorizonSurvey survey = new(hard.Terrain, hard.Tracer, directions, isMoon: true) { IsFine = isFine };
            return new HorizonsOf(survey, survey.Find(directions, height, threads: 2, advanced: null, CancellationToken.None));
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

    /// <summary>A place and times, with its horizons as files keep them and as points have them.</summary>
    private sealed record Case(
        Vector3D[] Directions, HorizonsOf Kept, HorizonsOf Fine, int Place, LocalFrame Frame, float[] Tangents, Vector3D[] Suns);

    private sealed record HorizonsOf(HorizonSurvey Survey, PlaceHorizons Horizons);
}
