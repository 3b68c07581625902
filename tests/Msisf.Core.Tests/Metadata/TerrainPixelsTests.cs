using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Metadata;

/// <summary>Grid pixels on the terrain, through the sampler that the writers use.</summary>
public class TerrainPixelsTests
{
    /// <summary>A nadir camera over (0, 0), north up: it looks along -x, y is right, z is up.</summary>
    private static readonly PinholeCamera Nadir = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity, 0.7, 101, 101);

    [Fact]
    public void Sample_PixelOnASlope_HasTheNumbersOfItsPoint()
    {
        // 600 m over the reference radius; the facet leans 10 degrees to the north, the Sun stands 40 degrees north of the zenith.
        Vector3D point = new(1_738_000.0, 0.0, 0.0);
        Vector3D toSun = FromZenith(40.0);
        SurfaceHit hit = new(point, FromZenith(10.0), new FacetId(359, 1439, FacetHalf.NorthEast), 1.0);
        PixelIllumination light = new(IlluminationState.Penumbra, 0.25);
        FunctionTruth truth = new(Nadir, point + (1e11 * toSun), (_, _) => (hit, light));

        PixelRecord record = Assert.Single(Sampler(truth, spacing: 51).Sample());

        Assert.Equal((51, 51), (record.H, record.V));
        Assert.Equal(new SelenographicPoint(0.0, 0.0), record.Point);
        Assert.Equal(180.0, double.RadiansToDegrees(record.IlluminationDirection!.Value), 12);
        TerrainRecord terrain = record.Terrain!.Value;
        Assert.Equal(600.0, terrain.Height);
        Assert.Equal(262_000.0, terrain.Range);
        Assert.Equal(30.0, double.RadiansToDegrees(terrain.Angles.Incidence), 12);
        Assert.Equal(10.0, double.RadiansToDegrees(terrain.Angles.Emission), 12);
        Assert.Equal(40.0, double.RadiansToDegrees(terrain.Angles.Phase), 12);
        Assert.Equal(
            (point, hit.NormalBodyFixed, light, hit.Facet, new TileId(0, 355)),
            (terrain.PositionBodyFixed, terrain.NormalBodyFixed, terrain.Light, terrain.Facet, terrain.Tile));
    }

    [Fact]
    public void Sample_TerrainOverTheLimb_IsThereWhereTheSphereIsNot()
    {
        // A mountain in a pixel that looks past the reference sphere, and space where it would be met.
        SurfaceHit mountain = new(new Vector3D(1.5e6, 1e6, 0.0), Vector3D.UnitX, default, 1.0);
        FunctionTruth truth = new(Nadir, 1e11 * Vector3D.UnitX, (x, _) => x == 101 ? (mountain, default) : null);

        PixelRecord[] records = [.. Sampler(truth, spacing: 1).Sample()];

        Assert.Equal(Enumerable.Range(1, 101).Select(y => (101, y)), records.Select(record => (record.H, record.V)));
    }

    [Fact]
    public void Sample_PointsOnTheSphere_MeetsTheReferencesOfTheSphere()
    {
        // The same point on the same ray has the same coordinates and direction, whoever finds it.
        foreach (ReferencePixel expected in ReferencePixel.Read("moderate"))
        {
            FunctionTruth truth = FunctionTruth.OfSphere(expected.Camera, expected.Sun);
            PixelGrid onePixel = new(expected.X, expected.Y, expected.X, expected.Y);

            PixelRecord actual = Assert.Single(new PixelSampler(onePixel, truth, 4).Sample());

            Assert.InRange(
                double.RadiansToDegrees(actual.Point.Latitude) - expected.LatitudeDegrees, -Rounding.OfChains, Rounding.OfChains);
            Assert.InRange(
                ReferencePixel.Apart(double.RadiansToDegrees(actual.Point.Longitude), expected.LongitudeDegrees), 0.0, Rounding.OfChains);
            Assert.InRange(
                ReferencePixel.Apart(double.RadiansToDegrees(actual.IlluminationDirection!.Value), expected.DirectionDegrees), 0.0, 1e-12);
        }
    }

    [Fact]
    public void Surface_OfEachKind_IsNamed()
    {
        PixelGrid grid = new(101, 101, 50, 50);
        FunctionTruth truth = new(Nadir, 1e11 * Vector3D.UnitX, (_, _) => null);

        Assert.Equal(PixelSurface.Terrain, new PixelSampler(grid, truth, 4).Surface);
        SceneLight sun = new(1e11 * Vector3D.UnitX, IsSun: true);
        Assert.Equal(PixelSurface.Sphere, new PixelSampler(Nadir, grid, ReferenceSphere.Lola, sun).Surface);
    }

    private static PixelSampler Sampler(IGroundTruth truth, int spacing) => new(new PixelGrid(101, 101, spacing, spacing), truth, 4);

    private static Vector3D FromZenith(double degreesNorth)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(degreesNorth));
        return new Vector3D(cosine, 0.0, sine);
    }
}
