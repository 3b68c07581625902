using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

public sealed class HorizonSurveyTests
{
    private static ITerrain Terrain(string kind) => kind switch
    {
        "nested" => new NestedTerrain([FunctionGrid.Rugged(1), PolarFunctionGrid.Rugged(true, 600.0, 500, 249.5, 249.5)]),
        "rugged" => FunctionGrid.Rugged(4),
        _ => FunctionGrid.Hilly(4),
    };

    /// <summary>
    /// The stored horizon, and that by rays which are spared where a facet is known, against halving between rays of the exact tracer that
    /// hit and rays that pass.
    /// </summary>
    [Theory]
    [InlineData("rugged", -89.9, 12.0, 0.0)]
    [InlineData("rugged", 81.0, 300.0, 10.0)]
    [InlineData("nested", -89.0, 100.0, 2.0)]
    [InlineData("nested", -85.7, 45.0, 0.0)]
    [InlineData("hilly", -75.0, 359.9, 0.0)]
    public void Find_AnyAzimuth_IsTheTracersHorizonWithinTheStatedError(string kind, double latitude, double longitude, double height)
    {
        ITerrain terrain = Terrain(kind);
        TerrainTracer tracer = new(terrain);
        Random random = new(31);
        Vector3D[] directions = [.. Enumerable.Range(0, TestLength.Of(2, 100)).Select(_ => new SelenographicPoint(
            double.DegreesToRadians(latitude + (0.1 * (random.NextDouble() - 0.5))),
            double.DegreesToRadians(longitude)).ToDirectionBodyFixed())];
        HorizonSurvey survey = new(terrain, tracer, directions, isMoon: true);
        PlaceHorizons horizons = survey.Find(directions, height, threads: 2, advanced: null, CancellationToken.None);
        for (int place = 0; place < directions.Length; place++)
        {
            LocalFrame frame = LocalFrame.At(horizons.Radii[place] * directions[place]);
            float[] tangents = survey.HorizonOf(horizons, place);
            PlaceRays rays = survey.RaysFrom(frame);
            for (int ray = 0; ray < 60; ray++)
            {
                double turns = random.NextDouble();
                double exact = double.RadiansToDegrees(Horizon(tracer, frame, 2.0 * Math.PI * turns));
                double column = turns * HorizonSurvey.Columns;
                double tangent = tangents[(int)column] + ((column - (int)column) * (tangents[(int)column + 1] - tangents[(int)column]));
                double found = double.RadiansToDegrees(Math.Atan(tangent));

                double guess = Math.Atan(tangent) + (ray % 3 == 0 ? 0.2 * (random.NextDouble() - 0.5) : 0.0);
                (double elevation, SurfaceHit hit) = rays.HorizonAt(2.0 * Math.PI * turns, guess);
                Assert.Equal(exact, double.RadiansToDegrees(elevation), 1.2e-6); // each is between two rays 5.7E-7 degrees apart
                Vector3D below = frame.DirectionOf(2.0 * Math.PI * turns, elevation - 1e-8);
                Assert.Equal(1.0, Vector3D.Dot((hit.PointBodyFixed - frame.PositionBodyFixed).Normalized(), below), 1e-12);

                // Above the band in which the Sun and the Earth can stand nothing needs to be known.
                float top = survey.Band.Tops[(int)column / HorizonBuffer.Group];
                if (exact < double.RadiansToDegrees(Math.Atan(top)) - 0.01)
                {
                    Assert.Equal(exact, found, HorizonSurvey.ErrorDegrees);
                }
            }
        }
    }

    /// <summary>Places are shared out to threads as it comes; what is found for each is the same to the bit.</summary>
    [Fact]
    public void Find_OneThreadAndFour_FindTheSame()
    {
        ITerrain terrain = Terrain("nested");
        TerrainTracer tracer = new(terrain);
        Vector3D[] directions = [.. Enumerable.Range(0, 130).Select( // three pieces of work
            place => new SelenographicPoint(-1.56 + (1e-5 * place), 0.005 * place).ToDirectionBodyFixed())];
        HorizonSurvey survey = new(terrain, tracer, directions, isMoon: true);
        PlaceHorizons one = survey.Find(directions, 0.0, threads: 1, advanced: null, CancellationToken.None);
        PlaceHorizons four = survey.Find(directions, 0.0, threads: 4, advanced: null, CancellationToken.None);
        Assert.Equal(one.Ends, four.Ends);
        Assert.Equal(one.Corners, four.Corners);
    }

    [Fact]
    public void Find_PlaceOutsideAMap_SaysWhere()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 600.0, 100, 49.5, 49.5);
        TerrainTracer tracer = new(map);
        Vector3D[] directions = [new SelenographicPoint(-1.0, 0.5).ToDirectionBodyFixed()];
        HorizonSurvey survey = new(map, tracer, directions, isMoon: true);
        BadInputException exception = Assert.Throws<BadInputException>(
            () => survey.Find(directions, 0.0, threads: 1, advanced: null, CancellationToken.None));
        Assert.Contains("latitude -57.2958, longitude 28.6479", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>A sphere has no mountains: the horizon dips by acos(R / (R + h)).</summary>
    [Theory]
    [InlineData(1_737_400.0, 0.0, 0.0)]
    [InlineData(1_737_400.0, 2.0, -0.0869366)]
    [InlineData(1_737_400.0, 1000.0, -1.9434957)]
    [InlineData(100_000.0, 10_000.0, -24.6199773)]
    public void Find_SmoothSphere_DipsByItsHeight(double radius, double height, double expectedDegrees)
    {
        FunctionGrid sphere = new(16, (_, _) => radius) { ReferenceRadius = radius };
        TerrainTracer tracer = new(sphere);
        Vector3D[] directions = [new SelenographicPoint(-1.55, 0.3).ToDirectionBodyFixed()];
        HorizonSurvey survey = new(sphere, tracer, directions, isMoon: radius > 1e6);
        PlaceHorizons horizons = survey.Find(directions, height, threads: 1, advanced: null, CancellationToken.None);
        float[] tangents = survey.HorizonOf(horizons, 0);

        // Facets are flat: within 0.06 degrees of the sphere, half the angle of a cell's diagonal; the lowest are near it.
        Assert.All(tangents, tangent => Assert.Equal(expectedDegrees, double.RadiansToDegrees(Math.Atan(tangent)), 0.06));
    }

    private static double Horizon(TerrainTracer tracer, LocalFrame frame, double azimuth)
    {
        (double low, double high) = (-0.5, 1.5);
        while (high - low > 1e-8)
        {
            double middle = 0.5 * (low + high);
            bool isGround = tracer.TryTrace(new Ray(frame.PositionBodyFixed, frame.DirectionOf(azimuth, middle)), out _);
            (low, high) = isGround ? (middle, high) : (low, middle);
        }

        return 0.5 * (low + high);
    }
}
