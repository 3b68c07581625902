using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>Limits a ray to the wedge from the Moon's centre in which the facets of a rectangle of cells lie.</summary>
/// <remarks>
/// A half space that holds the vertices also holds the facets, so the borders are planes that bound the vertices. The western and eastern
/// borders are meridian planes. The vertices of a parallel do not lie in one plane through the centre. So the border is the plane through
/// the two corners on one side of the equator, and the plane that touches the parallel in the middle on the other. With half the
/// rectangle's width D and the longitude d from its middle, a vertex at latitude p is north of the plane with slope q if tan p >= cos d tan
/// q, and cos D &lt;= cos d &lt;= 1. Rounding to the lattice moves a vertex by up to 7 mm, less than
/// <see cref="Tolerances.VertexLattice"/>.
/// </remarks>
internal readonly struct CellWedge
{
    private readonly SurfaceModel _surface;
    private readonly Vector3D _start;
    private readonly Vector3D _direction;

    /// <summary>Prepares the cuts of a ray.</summary>
    /// <param name="surface">The surface, which gives the directions of lines and samples.</param>
    /// <param name="start">Point of the ray at which a piece's position is 0, m, MOON_ME.</param>
    /// <param name="direction">Unit vector, MOON_ME.</param>
    public CellWedge(SurfaceModel surface, Vector3D start, Vector3D direction)
    {
        _surface = surface;
        _start = start;
        _direction = direction;
    }

    /// <summary>Maximum width, in degrees, of a rectangle that two planes through the axis can bound well.</summary>
    public static int WidestDegrees => 90;

    /// <summary>The part of a piece between the rectangle's western and eastern border.</summary>
    public RayPiece CutAtMeridians(CellRange cells, RayPiece piece)
    {
        if (cells.Samples > WidestDegrees * _surface.Grid.PixelsPerDegree)
        {
            return piece;
        }

        SineCosine west = _surface.Longitude(cells.FirstSample);
        SineCosine east = _surface.Longitude(cells.EndSample);
        return Cut(Cut(piece, new Vector3D(-west.Sine, west.Cosine, 0.0)), new Vector3D(east.Sine, -east.Cosine, 0.0));
    }

    /// <summary>
    /// The part of a piece between the rectangle's northern and southern border; it is at most <see cref="WidestDegrees"/> wide.
    /// </summary>
    public RayPiece CutAtParallels(CellRange cells, RayPiece piece)
    {
        SineCosine west = _surface.Longitude(cells.FirstSample);
        SineCosine east = _surface.Longitude(cells.EndSample);

        // Direction of the rectangle's middle. Its length is the cosine of half the rectangle's width, which shortens the normals below by
        // the same factor.
        double x = 0.5 * (west.Cosine + east.Cosine);
        double y = 0.5 * (west.Sine + east.Sine);
        double squaredCosine = (x * x) + (y * y);
        double cosine = Math.Sqrt(squaredCosine);
        SineCosine north = _surface.Latitude(cells.FirstLine);
        SineCosine south = _surface.Latitude(cells.EndLine);
        double northZ = north.Cosine * (north.Sine >= 0.0 ? squaredCosine : cosine);
        double southZ = south.Cosine * (south.Sine >= 0.0 ? cosine : squaredCosine);
        return Cut(
            Cut(piece, new Vector3D(north.Sine * x, north.Sine * y, -northZ)),
            new Vector3D(-south.Sine * x, -south.Sine * y, southZ));
    }

    private RayPiece Cut(RayPiece piece, Vector3D inwardNormal) => piece.WhereNotNegative(
        Vector3D.Dot(inwardNormal, _start) + Tolerances.VertexLattice, Vector3D.Dot(inwardNormal, _direction));
}
