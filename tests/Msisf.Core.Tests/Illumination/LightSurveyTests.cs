using Msisf.Core.Camera;
using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

/// <summary>Light against rays of the exact tracer, on a nested surface, with the Sun near the horizon of each place.</summary>
public sealed class LightSurveyTests
{
    private const double Distance = 1.5e11;

    private readonly ITerrain _terrain = new NestedTerrain(
        [FunctionGrid.Rugged(1), PolarFunctionGrid.Rugged(true, 600.0, 500, 249.5, 249.5)]);
    private readonly TerrainTracer _tracer;
    private readonly Vector3D[] _directions;
    private readonly HorizonSurvey _survey;
    private readonly PlaceHorizons _horizons;
    private readonly Random _random = new(18);

    public LightSurveyTests()
    {
        _tracer = new TerrainTracer(_terrain);
        _directions = [.. Enumerable.Range(0, TestLength.Of(4, 200)).Select(_ => new SelenographicPoint(
            double.DegreesToRadians(-90.0 + (3.0 * _random.NextDouble())),
            2.0 * Math.PI * _random.NextDouble()).ToDirectionBodyFixed())];
        _survey = new HorizonSurvey(_terrain, _tracer, _directions, isMoon: true);
        _horizons = _survey.Find(_directions, 2.0, threads: 2, advanced: null, CancellationToken.None);
    }

    /// <summary>The Sun as a point: the same as a ray to it, for any step, about half of them within 0.02 degrees of the horizon.</summary>
    [Fact]
    public void At_ExactPointSun_IsTheTracersAnswerWithoutException()
    {
        for (int place = 0; place < _directions.Length; place++)
        {
            LocalFrame frame = FrameOf(place);
            Vector3D[] suns = [.. Suns(frame, TangentsOf(place), 50, 0.02)];
            LightSurvey lights = LightsOf(suns, isPoint: true, isExact: true);
            (PlaceLight light, float[] parts) = lights.At(_directions, _horizons, place);
            bool[] expected = [.. suns.Select(
                sun => !_tracer.TryTrace(new Ray(frame.PositionBodyFixed, sun - frame.PositionBodyFixed), out _))];
            Assert.Equal(expected, parts.Select(part => part > 0.0f));
            Assert.Equal(expected.Count(isLit => isLit), light.LitSteps);
        }
    }

    /// <summary>Without rays a wrong answer comes only within the stated error of the horizon.</summary>
    [Fact]
    public void At_PointSun_IsWrongOnlyWithinTheStatedError()
    {
        for (int place = 0; place < _directions.Length; place++)
        {
            LocalFrame frame = FrameOf(place);
            Vector3D[] suns = [.. Suns(frame, TangentsOf(place), 50, 0.02)];
            (_, float[] parts) = LightsOf(suns, isPoint: true, isExact: false).At(_directions, _horizons, place);
            for (int step = 0; step < suns.Length; step++)
            {
                double error = double.DegreesToRadians(HorizonSurvey.ErrorDegrees);
                if (IsFree(frame, suns[step], error) == IsFree(frame, suns[step], -error))
                {
                    Assert.Equal(IsFree(frame, suns[step], 0.0), parts[step] > 0.0f);
                }
            }
        }
    }

    /// <summary>
    /// The visible part of the disc against 4,096 rays, equal parts of its area; and with rays for its edge some part is in view exactly
    /// when one of those rays passes, but where only a sliver is left.
    /// </summary>
    [Theory]
    [InlineData(false, 0.02)]
    [InlineData(true, 0.01)]
    public void At_Disc_IsThePartOfRays(bool isFine, double tolerance)
    {
        PlaceHorizons fine = new HorizonSurvey(_terrain, _tracer, _directions, isMoon: true) { IsFine = true }
            .Find(_directions, 2.0, threads: 2, advanced: null, CancellationToken.None);
        double radius = LightSurvey.SunRadius / Math.Sqrt((Distance - LightSurvey.SunRadius) * (Distance + LightSurvey.SunRadius));
        for (int place = 0; place < _directions.Length; place++)
        {
            LocalFrame frame = FrameOf(place);
            Vector3D[] suns = [.. Suns(frame, TangentsOf(place), TestLength.Of(2, 10), 0.3)];
            LightSurvey lights = LightsOf(suns, isPoint: false, isExact: isFine);
            (PlaceLight light, float[] parts) = isFine
                ? lights.At(_directions, fine, place)
                : lights.At(_directions, _horizons, place);
            Assert.Equal(parts.Average(), light.DiscPart, 1e-6);
            for (int step = 0; step < suns.Length; step++)
            {
                Vector3D toSun = (suns[step] - frame.PositionBodyFixed).Normalized();
                Vector3D right = Vector3D.Cross(toSun, frame.Up).Normalized();
                Vector3D up = Vector3D.Cross(right, toSun);
                int free = 0;
                for (int ray = 0; ray < 4096; ray++)
                {
                    double turn = ray * 2.39996322972865332; // the golden angle: even over the disc
                    double across = radius * Math.Sqrt((ray + 0.5) / 4096.0);
                    Vector3D direction = toSun + (across * Math.Cos(turn) * right) + (across * Math.Sin(turn) * up);
                    free += _tracer.TryTrace(new Ray(frame.PositionBodyFixed, direction), out _) ? 0 : 1;
                }

                Assert.Equal(free / 4096.0, parts[step], tolerance);
                Assert.True(!isFine || free == 0 || parts[step] > 0.0f);
            }
        }
    }

    /// <summary>A year hour by hour: the part of the time with light in a map is that with rays wherever there is a doubt.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Of_AYear_IsLitWithinAThousandth(bool isPoint)
    {
        Vector3D[] suns = [.. Enumerable.Range(0, 8761).Select(hour => SunOfAYear(hour / 24.0))];
        int count = TestLength.Of(1, 40);
        PlaceLight[] lights = LightsOf(suns, isPoint, isExact: false).Of(_directions, _horizons, 2, null, CancellationToken.None);
        LightSurvey exact = LightsOf(suns, isPoint, isExact: true);
        for (int place = 0; place < count; place++)
        {
            PlaceLight expected = exact.At(_directions, _horizons, place).Light;
            Assert.Equal((double)expected.LitSteps / suns.Length, (double)lights[place].LitSteps / suns.Length, 0.001);
            Assert.Equal(expected.DiscPart, lights[place].DiscPart, 0.001);
        }
    }

    /// <summary>The paths of the Sun and the Earth are shared by neighbours: the same as if each was looked at alone.</summary>
    [Fact]
    public void Of_Neighbours_IsTheLightOfEachAlone()
    {
        const int Count = 40;
        Vector3D[] suns = [.. Enumerable.Range(0, 2000).Select(hour => SunOfAYear(hour / 24.0))];
        Vector3D[] earths = [.. suns.Select(sun => 3.8e8 * new SelenographicPoint(
            0.11 * Math.Sin(31.0 * sun.X / Distance), 0.13 * Math.Sin(17.0 * sun.Y / Distance)).ToDirectionBodyFixed())];
        Vector3D[] row = [.. Enumerable.Range(0, Count).Select(place => new SelenographicPoint(
            double.DegreesToRadians(-89.4 + (0.002 * place)), 1.0 + (0.004 * place)).ToDirectionBodyFixed())];
        HorizonSurvey survey = new(_terrain, _tracer, row, isMoon: true);
        PlaceHorizons horizons = survey.Find(row, 0.0, threads: 2, advanced: null, CancellationToken.None);
        LightSurvey lights = new(survey, new LightConditions(suns, earths) { FixedPlane = new Vector3D(0.6, 0.0, 0.8) }, _tracer);
        PlaceLight[] together = lights.Of(row, horizons, threads: 2, advanced: null, CancellationToken.None);
        for (int place = 0; place < Count; place++)
        {
            PlaceLight alone = lights.At(row, horizons, place).Light;
            Assert.InRange(Math.Abs(alone.LitSteps - together[place].LitSteps), 0, 2);
            Assert.InRange(Math.Abs(alone.EarthSteps - together[place].EarthSteps), 0, 2);
            Assert.InRange(Math.Abs(alone.WholeEarthSteps - together[place].WholeEarthSteps), 0, 2);
            Assert.Equal(alone.DiscPart, together[place].DiscPart, 0.001);
            Assert.Equal(alone.Tracking.Mean, together[place].Tracking.Mean, 1.0);
            Assert.Equal(alone.Horizontal.Mean, together[place].Horizontal.Mean, 0.05);
            Assert.Equal(alone.Fixed.Mean, together[place].Fixed.Mean, 1.0);
        }
    }

    /// <summary>High in the sky all of the Sun's light comes: 1361 W/m^2 at one au, and its sine on a horizontal plane.</summary>
    [Fact]
    public void Of_SunHighAndLow_HasTheFluxOfItsDistance()
    {
        const double Au = 149_597_870_700.0;
        LocalFrame frame = FrameOf(0);
        Vector3D[] suns = [2.0 * Au * frame.DirectionOf(1.0, 0.6), Au * frame.DirectionOf(1.0, -0.6)];
        LightSurvey lights = LightsOf(suns, isPoint: false, isExact: false);
        PlaceLight light = lights.Of(_directions, _horizons, threads: 1, advanced: null, CancellationToken.None)[0];
        Assert.Equal(1361.0 / 4.0, light.Tracking.Greatest, 0.01);
        Assert.Equal(1361.0 / 8.0, light.Tracking.Mean, 0.01);
        Assert.Equal(1361.0 / 4.0 * Math.Sin(0.6), light.Horizontal.Greatest, 0.02);
        Assert.Equal((1, 1, 0.5), (light.LitSteps, light.Dark.Count, light.DiscPart));
    }

    private static Vector3D SunOfAYear(double day) => Distance * new SelenographicPoint(
        double.DegreesToRadians(1.54) * Math.Sin(2.0 * Math.PI * day / 346.6),
        Math.IEEERemainder(1.0 - (2.0 * Math.PI * day / 29.53), 2.0 * Math.PI)).ToDirectionBodyFixed();

    private LightSurvey LightsOf(Vector3D[] suns, bool isPoint, bool isExact) => new(
        _survey, new LightConditions(suns, [.. suns.Select(_ => 4e8 * Vector3D.UnitX)]) { IsPoint = isPoint, IsExact = isExact }, _tracer);

    private LocalFrame FrameOf(int place) => LocalFrame.At(_horizons.Radii[place] * _directions[place]);

    private float[] TangentsOf(int place) => LightsOf([Distance * Vector3D.UnitX], true, false).HorizonOf(_horizons, place);

    private bool IsFree(LocalFrame frame, Vector3D sun, double higher)
    {
        Vector3D local = frame.ToLocal(sun - frame.PositionBodyFixed);
        double elevation = Math.Atan2(local.Z, double.Hypot(local.X, local.Y)) + higher;
        return !_tracer.TryTrace(new Ray(frame.PositionBodyFixed, frame.DirectionOf(Math.Atan2(local.X, local.Y), elevation)), out _);
    }

    /// <summary>Places of the Sun in the sky of a place, near the horizon and anywhere where it can stand.</summary>
    private IEnumerable<Vector3D> Suns(LocalFrame frame, float[] tangents, int count, double nearDegrees)
    {
        while (count > 0)
        {
            double turns = _random.NextDouble();
            double horizon = double.RadiansToDegrees(Math.Atan(tangents[(int)(turns * HorizonSurvey.Columns)]));
            double elevation = _random.Next(2) == 0
                ? horizon + (nearDegrees * ((2.0 * _random.NextDouble()) - 1.0))
                : -4.0 + (8.0 * _random.NextDouble());
            double highest = double.RadiansToDegrees(Math.Atan(_survey.Band.Tops[(int)(turns * _survey.Band.Tops.Length)]));
            if (elevation > -4.0 && elevation < highest - 0.6)
            {
                count--;
                yield return frame.PositionBodyFixed
                    + (Distance * frame.DirectionOf(2.0 * Math.PI * turns, double.DegreesToRadians(elevation)));
            }
        }
    }
}
