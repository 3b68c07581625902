using Msisf.Core.Errors;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class TerrainHeightTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    /// <summary>m: half the diagonal of the lattice of vertices.</summary>
    private static readonly double HalfStep = 0.5 * Math.Sqrt(3.0) / LatticePoint.StepsPerMetre;

    /// <summary>Maps with a lattice of 2^-7 m and with finer ones, in both projections.</summary>
    public static TheoryData<ITerrainGrid> LoneMaps => new()
    {
        PolarFunctionGrid.Rugged(isSouth: true, 5000.0, 70, 34.5, 34.5),
        PolarFunctionGrid.Rugged(isSouth: false, 5.0, 80, 39.5, -15.5),
        new WindowGrid(FunctionGrid.Rugged(6), new GridWindow(6 * 60, 6 * 75, 6 * 350, (6 * 368) + 1)),
        new WindowGrid(FunctionGrid.Rugged(4096), new GridWindow(4096 * 70, (4096 * 70) + 60, 4096 * 20, (4096 * 20) + 50)),
    };

    [Theory]
    [MemberData(nameof(LoneMaps), DisableDiscoveryEnumeration = true)]
    public void RadiusBelow_LoneMap_IsWhereRaysFromOutsideMeetIt(ITerrainGrid map)
    {
        GroundBelow ground = new(map);
        CellRange cells = new FacetMesh(map).Cells;
        Random random = new(20120223);
        for (int number = 0; number < 200; number++)
        {
            double line = cells.FirstLine + 1 + (random.NextDouble() * (cells.Lines - 2));
            double sample = cells.FirstSample + 1 + (random.NextDouble() * (cells.Samples - 2));
            Vector3D northWest = map.Projection.DirectionOf((int)line, (int)sample);
            Vector3D southEast = map.Projection.DirectionOf((int)line + 1, (int)sample + 1);
            double share = random.NextDouble();
            Vector3D direction = (((1.0 - share) * northWest) + (share * southEast)).Normalized();

            Assert.Equal(ground.RadiusAt(direction), TerrainHeight.RadiusBelow(map, 1.8e6 * direction), 1e-6);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void RadiusBelow_ManyDirections_IsWhereARayFromTheCentreMeetsTheFacets()
    {
        Random random = new(20120222);
        for (int number = 0; number < 2000; number++)
        {
            double z = number < 200
                ? (number % 2 == 0 ? 1.0 : -1.0) * (1.0 - (1e-6 * random.NextDouble()))
                : (2.0 * random.NextDouble()) - 1.0;
            double longitude = (random.NextDouble() - (number < 400 ? 0.5 : 0.0)) * (number < 400 ? 1e-3 : 2.0 * Math.PI);
            double across = Math.Sqrt((1.0 - z) * (1.0 + z));
            Vector3D direction = new(across * Math.Cos(longitude), across * Math.Sin(longitude), z);

            Assert.Equal(ldem4.Moon.FirstHit(default, direction)!.Value.T, TerrainHeight.RadiusBelow(ldem4.Grid, direction), 1e-6);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void RadiusBelow_Pole_IsTheMeanOfTheLastRow()
    {
        double[] row = new double[1440];
        ldem4.Grid.ReadRadii(0, 0, row);

        double vertex = Math.Round(row.Average() * LatticePoint.StepsPerMetre) / LatticePoint.StepsPerMetre;
        Assert.Equal(vertex, TerrainHeight.RadiusBelow(ldem4.Grid, new Vector3D(0.0, 0.0, 3.0)), 1e-9);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(0.0)]
    [InlineData(1e-300)]
    [InlineData(1.3e-10)]
    [InlineData(1e-6)]
    [InlineData(1e-3)]
    [InlineData(1.0)]
    public void RadiusBelow_NextToAPole_IsTheFansRadius(double offset)
    {
        foreach (double z in (double[])[-2.2e6, 1.9e6])
        {
            double pole = TerrainHeight.RadiusBelow(ldem4.Grid, new Vector3D(0.0, 0.0, z));
            for (double angle = 0.0; angle < 6.3; angle += 0.1)
            {
                Vector3D position = new(offset * Math.Cos(angle), offset * Math.Sin(angle), z);
                Assert.Equal(pole, TerrainHeight.RadiusBelow(ldem4.Grid, position), 1.0);
            }
        }
    }

    [Fact]
    public void RadiusBelow_FinestModelBesideThePole_IsOnItsNarrowFacets()
    {
        FunctionGrid sphere = new(1024, (_, _) => 1_737_400.0);
        for (double offset = 0.1; offset < 1000.0; offset *= 1.37)
        {
            double radius = TerrainHeight.RadiusBelow(sphere, new Vector3D(-offset, 0.7 * offset, -1.9e6));
            Assert.InRange(radius, 1_737_399.99, 1_737_400.0 + HalfStep); // m: below a facet's sagitta too
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void RadiusBelow_OnASample_IsTheSample()
    {
        double[] radius = new double[1];
        ldem4.Grid.ReadRadii(338, 805, radius); // the highest: 10504.0 m at 5.375 N 201.375 E (LDEM_4's own maximum, 21008 x 0.5 m)
        SelenographicPoint point = new(5.375 * Math.PI / 180.0, 201.375 * Math.PI / 180.0);

        Assert.Equal(1_747_904.0, radius[0]);
        Assert.Equal(1_747_904.0, TerrainHeight.RadiusBelow(ldem4.Grid, 2e6 * point.ToDirectionBodyFixed()), HalfStep);
    }

    [RequiresFact(Part.Ldem4)]
    public void RequireAbove_JustOverAndUnderTheGround_TellsThemApart()
    {
        // in the deepest crater, 8.9 km under the reference
        Vector3D direction = new SelenographicPoint(-1.2282, 3.2747).ToDirectionBodyFixed();
        double ground = TerrainHeight.RadiusBelow(ldem4.Grid, direction);
        TerrainHeight.RequireAbove(ldem4.Grid, (ground + 1.0) * direction);

        Assert.True(ground < MoonConstants.ReferenceRadius - 7_000.0);
        Assert.Throws<BadInputException>(() => TerrainHeight.RequireAbove(ldem4.Grid, (ground - 1.0) * direction));
        Assert.Throws<BadInputException>(() => TerrainHeight.RequireAbove(ldem4.Grid, default));
    }
}
