using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tests.Support;

/// <summary>One ray of <see cref="FacetsNearRay"/> and the nearest facet that it was found to meet.</summary>
internal sealed class FacetSearch(LatticeVertices vertices, Vector3D origin, Vector3D direction, double minT)
{
    /// <summary>Parts of a facet: rays through an edge or a corner hit it.</summary>
    private const double EdgeTolerance = 1e-11;

    /// <summary>Cells around the ray that are tested to each side.</summary>
    private const int Around = 1;

    /// <summary>Lines beside a pole that are tested all around: there a step passes many meridians.</summary>
    private const int PolarLines = 4;

    private readonly HashSet<(int Line, int Sample)> _done = [];

    /// <summary>Parameter of the nearest hit; infinite if there is none.</summary>
    public double T { get; private set; } = double.PositiveInfinity;

    public FacetId? Facet { get; private set; }

    /// <summary>Tests the cells around a piece of the ray that is about as long as a cell.</summary>
    public void TestBetween(Vector3D from, Vector3D to)
    {
        (double line0, double sample0) = Place(from);
        (double line1, double sample1) = Place(to);
        double turn = sample1 - sample0;
        turn -= vertices.Samples * Math.Round(turn / vertices.Samples);
        int west = (int)Math.Floor(Math.Min(sample0, sample0 + turn)) - Around;
        int east = (int)Math.Floor(Math.Max(sample0, sample0 + turn)) + Around;
        int north = Math.Max((int)Math.Floor(Math.Min(line0, line1)) - Around, -1);
        int south = Math.Min((int)Math.Floor(Math.Max(line0, line1)) + Around, vertices.Lines - 1);
        for (int line = north; line <= south; line++)
        {
            bool isPolar = line < PolarLines || line >= vertices.Lines - 1 - PolarLines;
            (int first, int last) = isPolar ? (0, vertices.Samples - 1) : (west, east);
            for (int column = first; column <= last; column++)
            {
                int sample = ((column % vertices.Samples) + vertices.Samples) % vertices.Samples;
                if (_done.Add((line, sample)))
                {
                    TestCell(line, sample);
                }
            }
        }
    }

    private static Vector3D Cross(Vector3D u, Vector3D v) =>
        new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));

    /// <summary>Line and sample of a position, as fractions.</summary>
    private (double Line, double Sample) Place(Vector3D position)
    {
        double latitude = Math.Atan2(position.Z, Math.Sqrt((position.X * position.X) + (position.Y * position.Y)));
        double longitude = Math.Atan2(position.Y, position.X);
        return (((0.5 - (latitude / Math.PI)) * vertices.Lines) - 0.5, (longitude / (2.0 * Math.PI) * vertices.Samples) - 0.5);
    }

    private void TestCell(int line, int sample)
    {
        Vector3D northWest = vertices[line, sample];
        Vector3D southEast = vertices[line + 1, sample + 1];

        // Beside a pole one of the two facets has two corners there, and so no area.
        if (line < vertices.Lines - 1)
        {
            TestFacet(new FacetId(line, sample, FacetHalf.SouthWest), northWest, vertices[line + 1, sample], southEast);
        }

        if (line >= 0)
        {
            TestFacet(new FacetId(line, sample, FacetHalf.NorthEast), northWest, southEast, vertices[line, sample + 1]);
        }
    }

    /// <summary>T. Moeller, B. Trumbore, J. Graphics Tools 2 (1997) 21, both sides.</summary>
    private void TestFacet(FacetId facet, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D ab = b - a;
        Vector3D ac = c - a;
        Vector3D p = Cross(direction, ac);
        double determinant = Vector3D.Dot(ab, p);
        Vector3D fromA = origin - a;
        double u = Vector3D.Dot(fromA, p) / determinant;
        Vector3D q = Cross(fromA, ab);
        double v = Vector3D.Dot(direction, q) / determinant;
        double t = Vector3D.Dot(ac, q) / determinant;
        if (u >= -EdgeTolerance && v >= -EdgeTolerance && u + v <= 1.0 + EdgeTolerance && t >= minT && t < T)
        {
            T = t;
            Facet = facet;
        }
    }
}
