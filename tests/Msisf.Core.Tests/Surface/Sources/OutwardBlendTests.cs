using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

/// <summary>What coarser models get from finer ones in them.</summary>
public sealed class OutwardBlendTests
{
    private const double Radius = 1_737_400.0;

    /// <summary>Tangent of half a degree.</summary>
    private const double MaxSlope = 0.008726867790758789;

    /// <summary>m: the facets of a sphere with 8 px/deg lie up to a metre below it; outlines are divided into quarters of a cell.</summary>
    private const double Near = 2.5;

    /// <summary>A map over the sphere: each sample of the Moon around it gets what its distance from the outermost samples says.</summary>
    [Theory]
    [InlineData(100.0, 49.5, 49.5)]
    [InlineData(-100.0, 49.5, 49.5)]
    [InlineData(12.0, -6.5, 40.0)]
    public void ReadRadii_MapOffTheMoon_GetsTheDifferenceLessAndLessOutwards(double height, double poleLine, double poleSample)
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 1000.0, poleLine, poleSample), 100, 100, (_, _) => height);
        GridPatch moon = new NestedTerrain([map, new FunctionGrid(8, (_, _) => Radius)]).WholeParts[0];
        double cell = moon.Grid.Projection.Resolution.MetresPerPixel;
        double width = Math.Max(2.0 * cell, 1.5 * Math.Abs(height) / MaxSlope);
        Vector3D[] outline = [.. Enumerable.Range(0, 100).SelectMany(i => ((int, int)[])[(0, i), (99, i), (i, 0), (i, 99)]).Select(
            at => Radius * map.Projection.DirectionOf(at.Item1, at.Item2))];
        (int changed, int far) = (0, 0);
        double[] radius = new double[1];
        for (int line = 1380; line < 1440; line++)
        {
            for (int sample = 0; sample < 2880; sample += 31)
            {
                Vector3D place = Radius * moon.Grid.Projection.DirectionOf(line, sample);
                double t = Math.Min(1.0, outline.Min(one => (one - place).Length) / width);
                moon.Grid.ReadRadii(line, sample, radius);
                Assert.InRange(radius[0] - Radius - (height * (1.0 - t) * (1.0 - t) * (1.0 + (2.0 * t))), -Near, Near);
                changed += t < 0.5 ? 1 : 0;
                far += t == 1.0 && radius[0] == Radius ? 1 : 0;
            }
        }

        Assert.True(changed > 5 && far > 100, $"{changed} samples are near the map, {far} far away.");
    }

    /// <summary>However large the difference, it dies away by half a degree at most; a narrow hole gets nearly all of it.</summary>
    [Theory]
    [InlineData(3.0)]
    [InlineData(40.0)]
    [InlineData(900.0)]
    public void ReadRadii_AnyDifference_AddsNoSteeperSlope(double height)
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 500.0, 149.5, 149.5), 300, 300, (_, _) => height);
        GridWithGaps holed = new(map, (line, sample) => line is >= 145 and < 155 && sample is >= 145 and < 155);
        ITerrainGrid moon = new NestedTerrain([holed, new FunctionGrid(8, (_, _) => Radius)]).WholeParts[0].Grid;
        double[] above = new double[2880];
        double[] below = new double[2880];
        double step = moon.Projection.Resolution.MetresPerPixel;
        double steepest = 0.0;
        for (int line = 1300; line + 1 < 1440; line++)
        {
            moon.ReadRadii(line, 0, above);
            moon.ReadRadii(line + 1, 0, below);
            steepest = Math.Max(steepest, above.Zip(below, (one, other) => Math.Abs(one - other) / step).Max());
        }

        Assert.InRange(steepest, height > 100.0 ? 0.8 * MaxSlope : 0.0, 1.02 * MaxSlope);
        Assert.InRange(below[0] - Radius, 0.5 * height, height + Near); // beside the pole, in the middle of the hole
    }

    /// <summary>A place gets the mean of what the outlines within twice its distance and half a cell say, wherever they differ.</summary>
    [Fact]
    public void At_DifferencesOfARuggedOutline_AreTheMeanThatTheDocsDefine()
    {
        const double Cell = 2000.0;
        Random random = new(26);
        OutlineDifference[] differences = [.. Enumerable.Range(0, 3000).Select(i =>
        {
            double angle = 2.0 * Math.PI * i / 3000.0;
            Vector3D direction = new Vector3D(0.05 * Math.Cos(angle), 0.05 * Math.Sin(angle), -1.0).Normalized();
            return new OutlineDifference(Radius * direction, (80.0 * Math.Sin(3.0 * angle)) + (20.0 * random.NextDouble()), 182.0);
        })];
        OutlineField field = new(differences, Cell);
        int compared = 0;
        for (int number = 0; number < 300; number++)
        {
            double angle = 2.0 * Math.PI * random.NextDouble();
            double out0 = 0.05 + (0.03 * (random.NextDouble() - 0.4));
            Vector3D direction = new Vector3D(out0 * Math.Cos(angle), out0 * Math.Sin(angle), -1.0).Normalized();
            double distance = differences.Min(one => (one.Place - (Radius * direction)).Length);
            if (distance < 0.4 * Cell)
            {
                continue; // where no vertex of the coarser model is seen
            }

            double reach = (2.0 * distance) + (0.5 * Cell);
            (double weights, double heights) = (0.0, 0.0);
            foreach (OutlineDifference one in differences)
            {
                double part = (one.Place - (Radius * direction)).Length / reach;
                double weight = part < 1.0 ? Math.Pow(1.0 - (part * part), 2.0) : 0.0;
                (weights, heights) = (weights + weight, heights + (weight * one.Height));
            }

            double t = Math.Min(1.0, distance / Math.Max(2.0 * Cell, 1.5 * Math.Abs(heights) / weights / MaxSlope));
            Assert.InRange(field.At(direction) - (heights / weights * (1.0 - t) * (1.0 - t) * (1.0 + (2.0 * t))), -1.0, 1.0);
            compared++;
        }

        Assert.InRange(compared, 150, 300);
    }

    /// <summary>A site across the border of a map: all three meet without a step, and the site has its own heights.</summary>
    [Fact]
    public void Surface_ThreeModelsOfOtherHeights_MeetWithoutAStep()
    {
        PolarFunctionGrid map = new(new PolarStereographic(IsSouth: true, 1000.0, 49.5, 49.5), 100, 100, (_, _) => 60.0);
        PolarFunctionGrid site = new(new PolarStereographic(IsSouth: true, 100.0, 49.5, 549.5), 100, 100, (_, _) => -40.0);
        NestedTerrain terrain = new([map, site, new FunctionGrid(8, (_, _) => Radius)]);
        SeamPatch seams = terrain.Surface.Seams;
        for (int facet = 0; facet < seams.Count; facet++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(facet);
            double[] heights = [a.Length - Radius, b.Length - Radius, c.Length - Radius];
            double longest = Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));

            // No steeper than differences die away along the outline of two models; the rest is that of pieces of outlines.
            Assert.True(heights.Max() - heights.Min() <= (1.6 * MaxSlope * longest) + Near, $"{facet}: {string.Join(", ", heights)}");
        }

        Assert.True(seams.Count > 500);
        Assert.InRange(terrain.Surface.Parts[2].Corners(50, 50).NorthWest.Length - Radius, -40.1, -39.9);
    }
}
