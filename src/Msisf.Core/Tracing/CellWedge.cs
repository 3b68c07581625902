using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>Cuts a ray down to the wedge from the Moon's centre in which the facets of a rectangle of cells lie.</summary>
/// <remarks>
/// The vertices decide: what half space holds them holds the facets. East and west border are meridian planes. Along a parallel the
/// vertices bend out of each plane through the centre, so the border is the plane through the two corners on one side
/// of the equator and the plane that touches the parallel in the middle on the other: with half the rectangle's width D and the longitude d
/// from its middle, a vertex at latitude p is north of the plane with slope q if tan p >= cos d tan q, and cos D &lt;= cos d &lt;= 1.
/// Rounding to the lattice moves a vertex by up to 7 mm, less than <see cref="Tolerances.VertexLattice"/>.
/// </remarks>
internal readonly struct CellWedge
{
    private readonly SurfaceModel _surface;
    private readonly Vector3D _start;
    private readonly Vector3D _direction;

    /// <summary>Takes the ray.</summary>
    /// <param name="surface">Where lines and samples are.</param>
    /// <param name="start">m, MOON_ME: where a piece's parameter is 0.</param>
    /// <param name="direction">Unit vector, MOON_ME.</param>
    public CellWedge(SurfaceModel surface, Vector3D start, Vector3D direction)
    {
        _surface = surface;
        _start = start;
        _direction = direction;
    }

    /// <summary>Widest rectangle that two planes through the axis can bound well, in degrees.</summary>
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

        // Towards the rectangle's middle; the length is the cosine of half its width, by which the normals below are shortened too.
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
