using Msisf.Core.Camera;
using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

/// <summary>
/// Three models around the south pole, and places whose light is hard to tell: in each model, on the borders between them, anywhere on
/// the Moon, and where the horizon is a mountain beyond the pole.
/// </summary>
public sealed class HardPlaces
{
    /// <summary>m.</summary>
    public const double SunDistance = 1.5e11;

    private const double RealRadius = 695_700e3;

    /// <summary>rad: of the Sun at that distance.</summary>
    public static readonly double SunRadius =
        Math.Atan2(RealRadius, Math.Sqrt((SunDistance - RealRadius) * (SunDistance + RealRadius)));

    /// <summary>Joined once for all classes.</summary>
    private static readonly Lazy<(ITerrain Terrain, TerrainTracer Tracer)> Ground = new(() =>
    {
        NestedTerrain terrain = new([Mountainous(), WithPlain(600.0, 300), WithPlain(100.0, 200)]);
        return (terrain, new TerrainTracer(terrain));
    });

    /// <summary>The terrain.</summary>
    internal ITerrain Terrain { get; } = Ground.Value.Terrain;

    internal TerrainTracer Tracer { get; } = Ground.Value.Tracer;

    /// <summary>The Sun over a lunar year, m, body-fixed.</summary>
    internal static Vector3D SunAt(double day) => SunDistance * new SelenographicPoint(
        double.DegreesToRadians(1.54) * Math.Sin(2.0 * Math.PI * day / 346.6),
        Math.IEEERemainder(1.0 - (2.0 * Math.PI * day / 29.53), 2.0 * Math.PI)).ToDirectionBodyFixed();

    /// <summary>Kinds of places, and heights over their ground, m.</summary>
    public static TheoryData<string, double> Kinds => new()
    {
        { "coarse", 100.0 },
        { "middle", 2.0 },
        { "fine", 10.0 },
        { "border", 0.0 },
        { "inner border", 2.0 },
        { "anywhere", 0.0 },
        { "beyond", 2.0 },
    };

    /// <summary>Directions of places of a kind, each the highest of ten: from deep ones the Sun is never seen.</summary>
    internal Vector3D[] Of(string where, int count, Random random) => [.. Enumerable.Range(0, count).Select(
        _ => Enumerable.Range(0, 10).Select(_ => One(where, random)).MaxBy(
            direction => Tracer.TryTrace(new Ray(1.8e6 * direction, -direction), out SurfaceHit hit) ? hit.PointBodyFixed.Length : 0.0))];

    private static Vector3D One(string where, Random random)
    {
        double latitude = where switch
        {
            "coarse" => -78.0 - (5.0 * random.NextDouble()),
            "middle" => -87.3 - (2.0 * random.NextDouble()),
            "anywhere" => 180.0 * (random.NextDouble() - 0.5),
            _ => -89.75 - (0.2 * random.NextDouble()),
        };
        double longitude = where == "beyond" ? 160.0 + (40.0 * random.NextDouble()) : 360.0 * random.NextDouble();
        return where switch
        {
            "border" => OnBorder(89_700.0, 600.0),
            "inner border" => OnBorder(9_950.0, 100.0),
            _ => new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed(),
        };

        // Within two cells of the edge at X = half a map, on both sides of it.
        Vector3D OnBorder(double half, double cell)
        {
            PolarStereographic metres = new(true, 1.0, 0.0, 0.0);
            return metres.DirectionOf(half * ((2.0 * random.NextDouble()) - 1.0), half + (4.0 * cell * (random.NextDouble() - 0.5)));
        }
    }

    /// <summary>
    /// Places of the Sun in the sky of a place, m, body-fixed: half of them within 0.02 degrees of the horizon, a quarter with the disc's
    /// upper edge so near, the others anywhere where it can stand.
    /// </summary>
    /// <param name="where">Kind of place: "beyond" looks across the pole.</param>
    /// <param name="survey">Says where it can stand.</param>
    internal static IEnumerable<Vector3D> Suns(
        string where, LocalFrame frame, float[] tangents, HorizonSurvey survey, int count, Random random)
    {
        for (int tries = 0; count > 0; tries++)
        {
            Assert.InRange(tries, 0, 100_000);
            double turns = where == "beyond" ? Wrap(AcrossThePole(frame) + (0.02 * (random.NextDouble() - 0.5))) : random.NextDouble();
            double horizon = double.RadiansToDegrees(Math.Atan(tangents[(int)(turns * HorizonSurvey.Columns)]));
            double near = 0.04 * (random.NextDouble() - 0.5);
            double elevation = (count % 4) switch
            {
                0 or 1 => horizon + near,
                2 => horizon + near - double.RadiansToDegrees(SunRadius),
                _ => -4.0 + (8.0 * random.NextDouble()),
            };
            double highest = double.RadiansToDegrees(Math.Atan(survey.Band.Tops[(int)(turns * survey.Band.Tops.Length)]));
            if (elevation > -6.0 && elevation < highest - 0.6)
            {
                count--;
                yield return frame.PositionBodyFixed
                    + (SunDistance * frame.DirectionOf(2.0 * Math.PI * turns, double.DegreesToRadians(elevation)));
            }
        }
    }

    private static double AcrossThePole(LocalFrame frame)
    {
        Vector3D mountain = frame.ToLocal(new SelenographicPoint(double.DegreesToRadians(-84.5), 0.0).ToDirectionBodyFixed());
        return Math.Atan2(mountain.X, mountain.Y) / (2.0 * Math.PI);
    }

    private static double Wrap(double turns) => turns - Math.Floor(turns);

    /// <summary>A rugged map of the pole with a plain along the meridian of longitude 0 and 180 degrees.</summary>
    private static PolarFunctionGrid WithPlain(double scale, int side)
    {
        double middle = 0.5 * (side - 1);
        PolarFunctionGrid rugged = PolarFunctionGrid.Rugged(true, scale, side, middle, middle);
        double[] radius = new double[1];
        return new PolarFunctionGrid(rugged.Polar, side, side, (line, sample) =>
        {
            rugged.ReadRadii(line, sample, radius);
            double across = scale * Math.Abs(sample - middle);
            return (radius[0] - MoonConstants.ReferenceRadius) * Math.Clamp((across - 3_000.0) / 10_000.0, 0.02, 1.0);
        });
    }

    /// <summary>The rugged Moon with a mountain of 14 km at 84.5 degrees south, longitude 0, beside the maps.</summary>
    private static FunctionGrid Mountainous()
    {
        FunctionGrid rugged = FunctionGrid.Rugged(1);
        return new FunctionGrid(1, (line, sample) =>
        {
            double north = 90.0 - (line + 0.5) + 84.5;
            double east = 0.0958 * Math.IEEERemainder(sample + 0.5, 360.0); // cosine of the latitude
            return rugged.RadiusAt(line, sample) + (14_000.0 * Math.Exp(-((north * north) + (east * east))));
        });
    }
}
