using Msisf.Core.Render.Visibility;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

public sealed class InnerPixelsTests
{
    private const double Margin = 1.0 / 3.0;

    /// <summary>px: facets that touch the corner of a pixel's samples more closely may be found or not.</summary>
    private const double Doubt = 1e-3;

    /// <summary>Facets of all shapes: the range holds the pixels whose corners all lie in the facet, and no others.</summary>
    [Theory]
    [InlineData(1, 8.0)]
    [InlineData(2, 30.0)]
    [InlineData(3, 400.0)]
    public void At_RandomFacets_AreThePixelsWithin(int seed, double size)
    {
        Random random = new(seed);
        int inner = 0;
        for (int facet = 0; facet < 300; facet++)
        {
            (double X, double Y)[] corners =
            [
                .. Enumerable.Range(0, 3).Select(_ => (100.0 + (size * random.NextDouble()), 50.0 + (size * random.NextDouble()))),
            ];
            if (facet % 5 == 0)
            {
                corners[1].Y = corners[0].Y; // a side along a row
            }

            if (facet % 7 == 0)
            {
                corners[2].X = corners[0].X;
            }

            if (Side(corners[0], corners[1], corners[2]) > 0.0)
            {
                (corners[1], corners[2]) = (corners[2], corners[1]);
            }

            InnerPixels pixels = new(Corner(corners[0]), Corner(corners[1]), Corner(corners[2]), Margin);
            for (int row = 50; row <= 50 + size; row++)
            {
                (double first, double last) = pixels.At(row);
                for (int column = 100; column <= 100 + size; column++)
                {
                    bool isInner = column >= first && column <= last;
                    inner += isInner ? 1 : 0;
                    Assert.False(isInner && !IsWithin(corners, column, row, Margin), $"{column}, {row} of facet {facet}");
                    Assert.False(!isInner && IsWithin(corners, column, row, Margin + Doubt), $"{column}, {row} of facet {facet}");
                }
            }
        }

        Assert.True(inner > 300, "many pixels lie in a facet");
    }

    [Fact]
    public void FacetPlane_ThreeCorners_HasTheirDepths()
    {
        CellCorner a = new(3.0, 4.0, 1e-5);
        CellCorner b = new(1.0, 20.0, 1.1e-5);
        CellCorner c = new(30.0, 17.0, 0.7e-5);

        FacetPlane plane = FacetPlane.Of(a, b, c);

        foreach (CellCorner corner in new[] { a, b, c })
        {
            Assert.Equal(corner.InverseDepth, plane.At(corner.X, corner.Y), 1e-19);
        }
    }

    private static CellCorner Corner((double X, double Y) place) => new(place.X, place.Y, 1.0);

    private static bool IsWithin((double X, double Y)[] corners, double column, double row, double margin)
    {
        foreach ((double x, double y) in new[] { (-margin, -margin), (margin, -margin), (-margin, margin), (margin, margin) })
        {
            (double, double) point = (column + x, row + y);
            if (Side(corners[0], corners[1], point) > 0.0 || Side(corners[1], corners[2], point) > 0.0
                || Side(corners[2], corners[0], point) > 0.0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Twice the area of a triangle, above 0 if it is run through clockwise as seen in the image.</summary>
    private static double Side((double X, double Y) a, (double X, double Y) b, (double X, double Y) c) =>
        ((b.X - a.X) * (c.Y - a.Y)) - ((b.Y - a.Y) * (c.X - a.X));
}
