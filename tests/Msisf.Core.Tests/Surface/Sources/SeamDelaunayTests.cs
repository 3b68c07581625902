using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class SeamDelaunayTests
{
    /// <summary>rad: angles of needles, and the curvature of the sphere over the widest facets.</summary>
    private const double Rounding = 1e-6;

    /// <summary>The angles opposite a side between two facets of seams are half a turn at most: no circle holds a vertex beside.</summary>
    [Theory]
    [InlineData("five")]
    [InlineData("gaps")]
    [InlineData("crossing")]
    [InlineData("five at 0-102")]
    public void Surface_SidesWithinSeams_AreLocallyDelaunay(string name)
    {
        (int inner, int wrong) = CountWrongSides(NestedScenes.Named(name).Surface.Seams);
        Assert.True(inner > 100);
        Assert.Equal(0, wrong);
    }

    /// <summary>The check can fail: what is found first is not Delaunay.</summary>
    [Fact]
    public void Join_WhatIsFoundFirst_HasSidesThatAreNotDelaunay() =>
        Assert.True(CountWrongSides(SeamBuilder.Join(NestedScenes.Named("five").Surface.Parts, store: null)).Wrong > 0);

    private static (int Inner, int Wrong) CountWrongSides(SeamPatch seams)
    {
        Dictionary<(Vector3D From, Vector3D To), Vector3D> apexes = [];
        for (int facet = 0; facet < seams.Count; facet++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(facet);
            (apexes[(a, b)], apexes[(b, c)], apexes[(c, a)]) = (c, a, b);
        }

        (int inner, int wrong) = (0, 0);
        foreach (((Vector3D from, Vector3D to), Vector3D apex) in apexes)
        {
            if (apexes.TryGetValue((to, from), out Vector3D other))
            {
                inner++;
                bool isConvex = Side(other, to, apex) > 0.0 && Side(from, other, apex) > 0.0;
                wrong += isConvex && Angle(from, to, apex) + Angle(from, to, other) > Math.PI + Rounding ? 1 : 0;
            }
        }

        return (inner, wrong);
    }

    private static double Angle(Vector3D from, Vector3D to, Vector3D apex)
    {
        Vector3D place = apex.Normalized();
        return Vector3D.AngleBetween(from.Normalized() - place, to.Normalized() - place);
    }

    private static double Side(Vector3D a, Vector3D b, Vector3D c) => Vector3D.Dot(a, Vector3D.Cross(b - a, c - a));
}
