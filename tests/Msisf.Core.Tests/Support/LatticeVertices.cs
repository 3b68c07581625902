using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>The vertices of the surface by docs/pattern-format.md, one by one: a sample's lattice point, and the poles.</summary>
internal sealed class LatticeVertices
{
    private readonly IGlobalGrid _grid;
    private readonly GridDirections _directions;
    private readonly Vector3D _northPole;
    private readonly Vector3D _southPole;

    public LatticeVertices(IGlobalGrid grid)
    {
        _grid = grid;
        _directions = new GridDirections(grid.PixelsPerDegree);
        Lines = 180 * grid.PixelsPerDegree;
        Samples = 360 * grid.PixelsPerDegree;
        _northPole = Pole(0, 90);
        _southPole = Pole(Lines - 1, -90);
    }

    public int Lines { get; }

    public int Samples { get; }

    /// <summary>m, MOON_ME; line -1 and <see cref="Lines"/> are the poles, sample <see cref="Samples"/> is 0 again.</summary>
    public Vector3D this[int line, int sample]
    {
        get
        {
            if (line < 0 || line == Lines)
            {
                return line < 0 ? _northPole : _southPole;
            }

            Span<double> radius = stackalloc double[1];
            int column = sample % Samples;
            _grid.ReadRadii(line, column, radius);
            return LatticePoint.Nearest(radius[0], _directions.Latitude(line), _directions.Longitude(column)).PositionBodyFixed;
        }
    }

    /// <summary>The corners of a facet, counter-clockwise seen from outside.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet)
    {
        Vector3D northWest = this[facet.Line, facet.Sample];
        Vector3D southEast = this[facet.Line + 1, facet.Sample + 1];
        return facet.Half == FacetHalf.SouthWest
            ? (northWest, this[facet.Line + 1, facet.Sample], southEast)
            : (northWest, southEast, this[facet.Line, facet.Sample + 1]);
    }

    /// <summary>Outward, not of length 1.</summary>
    public Vector3D NormalOf(FacetId facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = CornersOf(facet);
        (Vector3D u, Vector3D v) = (b - a, c - a);
        return new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));
    }

    private Vector3D Pole(int line, int latitudeDegrees)
    {
        double[] radii = new double[Samples];
        _grid.ReadRadii(line, 0, radii);
        double sum = 0.0;
        foreach (double radius in radii)
        {
            sum += radius;
        }

        return LatticePoint.Nearest(sum / Samples, SineCosine.OfDegrees(latitudeDegrees, 1), SineCosine.OfDegrees(0, 1)).PositionBodyFixed;
    }
}
