using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

public class ImageEllipseTests
{
    /// <summary>Area inside the image, counted on a grid of a tenth of a pixel; columns of rows, counted pixel by pixel.</summary>
    [Fact]
    public void AreaInside_AnyEllipse_IsThatOfPointsCounted()
    {
        const int width = 60;
        const int height = 40;
        Random random = new(20120222);
        for (int number = 0; number < TestLength.Of(200, 5000); number++)
        {
            double major = Math.Exp((4.0 * random.NextDouble()) + 0.5);
            ImageEllipse ellipse = new(
                (100.0 * random.NextDouble()) - 20.0, (80.0 * random.NextDouble()) - 20.0, major,
                major * (0.1 + (0.9 * random.NextDouble())),
                Math.PI * (random.NextDouble() - 0.5));
            bool Holds(double x, double y)
            {
                (double u, double v) = ellipse.ToUnitCircle(x, y);
                return (u * u) + (v * v) <= 1.0;
            }

            int count = Enumerable.Range(0, 10 * height).Sum(
                row => Enumerable.Range(0, 10 * width).Count(column => Holds(0.55 + (0.1 * column), 0.55 + (0.1 * row))));
            double border = 2.0 * Math.PI * major;
            Assert.Equal(0.01 * count, ellipse.AreaInside(width, height), 0.05 + (0.03 * Math.Min(border, 300.0)));
            for (int row = 1; row <= height; row++)
            {
                (int first, int last) = ellipse.ColumnsOf(row, width);
                Assert.All(Enumerable.Range(1, width), column => Assert.Equal(column >= first && column <= last, Holds(column, row)));
            }
        }
    }

    [Fact]
    public void OfShape_ItsOwnAxes_AreFound()
    {
        ImageEllipse ellipse = new(3.0, -7.0, 1000.0, 1e-3, 0.3);

        ImageEllipse again = ImageEllipse.OfShape(
            3.0, -7.0,
            [(1000.0 * Math.Cos(0.3), 1000.0 * Math.Sin(0.3)), (-1e-3 * Math.Sin(0.3), 1e-3 * Math.Cos(0.3))]);

        // Last digits: the axes are 1,000 px and 0.001 px long.
        Assert.Equal(ellipse.SemiMajor, again.SemiMajor, 1e-10);
        Assert.Equal(ellipse.SemiMinor, again.SemiMinor, Rounding.OfUnits);
        Assert.Equal(ellipse.Angle, again.Angle, Rounding.OfUnits);
    }

    [Fact]
    public void TryFit_PointsOfAnEllipse_FindsIt()
    {
        ImageEllipse ellipse = new(1234.5, 777.25, 80.0, 3.0, -1.2);

        Assert.True(EllipseFit.TryFit(
            [.. Enumerable.Range(0, 24).Select(i => ellipse.PointAt(0.1 + (i * Math.PI / 12.0)))], out ImageEllipse found,
            out double residual));

        // The points lie on the ellipse to their last digits: 1e-13 of 1,000 px.
        Assert.Equal(ellipse.X, found.X, 1e-10);
        Assert.Equal(ellipse.Y, found.Y, Rounding.OfSolutions);
        Assert.Equal(ellipse.SemiMajor, found.SemiMajor, Rounding.OfSolutions);
        Assert.Equal(ellipse.SemiMinor, found.SemiMinor, Rounding.OfSolutions);
        Assert.Equal(ellipse.Angle, found.Angle, Rounding.OfChains);
        Assert.InRange(residual, 0.0, Rounding.OfSolutions);
    }

    [Fact]
    public void TryFit_PointsOnALine_FindsNone() => Assert.False(EllipseFit.TryFit(
        [.. Enumerable.Range(0, 24).Select(i => new RenderingPoint(i, 2.0 * i))], out _, out _));

    /// <summary>Points beside an ellipse by a wave of known size: the residual is the wave's, and the ellipse stays.</summary>
    [Fact]
    public void TryFit_WavyCurve_FindsTheMiddleAndTheResidual()
    {
        RenderingPoint[] curve =
        [
            .. Enumerable.Range(0, 64).Select(i =>
            {
                double angle = i * Math.PI / 32.0;
                double radius = 100.0 + Math.Cos(8.0 * angle);
                return new RenderingPoint(50.0 + (radius * Math.Cos(angle)), 60.0 + (radius * Math.Sin(angle)));
            }),
        ];

        Assert.True(EllipseFit.TryFit(curve, out ImageEllipse ellipse, out double residual));

        // The circle of 100 px fits best: to second order distances from it are those along the radius.
        Assert.Equal(100.0, ellipse.SemiMajor, 1e-6);
        Assert.Equal(50.0, ellipse.X, 1e-6); // px: the wave is even about the centre
        Assert.Equal(Math.Sqrt(0.5), residual, 1e-6);
    }

    /// <summary>Points of a normal of the ellipse lie as far from it as they were moved, up to the centre of its curvature.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(0.6)]
    [InlineData(0.02)]
    public void DistanceTo_PointOnANormal_IsItsWayAlongIt(double flat)
    {
        ImageEllipse ellipse = new(30.0, -20.0, 50.0, 50.0 * flat, 0.7);
        for (int number = 0; number < 100; number++)
        {
            double anomaly = 2.0 * Math.PI * number / 100.0;
            (double sin, double cos) = Math.SinCos(anomaly);
            double length = double.Hypot(flat * cos, sin);
            (double along, double across) = (flat * cos / length, sin / length);
            (double right, double down) = (
                (Math.Cos(0.7) * along) - (Math.Sin(0.7) * across), (Math.Sin(0.7) * along) + (Math.Cos(0.7) * across));
            double curvature = 50.0 * length * length * length / flat; // px: its radius; the major axis is 50 flat length away
            RenderingPoint point = ellipse.PointAt(anomaly);
            foreach (double way in (double[])[-0.9 * Math.Min(curvature, 50.0 * flat * length), -1e-6, 0.0, 1e-3, 4.0, 3000.0])
            {
                Assert.Equal(
                    Math.Abs(way), ellipse.DistanceTo(point.X + (way * right), point.Y + (way * down)), 1e-9 + (1e-12 * Math.Abs(way)));
            }
        }

        Assert.Equal(50.0 * flat, ellipse.DistanceTo(30.0, -20.0), Rounding.OfSolutions);
    }
}
