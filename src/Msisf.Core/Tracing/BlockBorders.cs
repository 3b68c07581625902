using Msisf.Core.Numerics;

namespace Msisf.Core.Tracing;

/// <summary>Cuts a ray down to the wedge from the Moon's centre in which a block's facets lie.</summary>
/// <remarks>
/// The vertices decide: what half space holds them holds the facets. East and west border are meridian planes. Along a parallel the
/// vertices bend out of each plane through the centre, so the border is the plane through the two corners on one side
/// of the equator and the plane that touches the parallel in the middle on the other: with half the block's width D and the longitude d
/// from its middle, a vertex at latitude p is north of the plane with slope q if tan p >= cos d tan q, and cos D &lt;= cos d &lt;= 1.
/// Rounding to the lattice moves a vertex by up to 7 mm, less than <see cref="Tolerances.VertexLattice"/>.
/// </remarks>
internal readonly struct BlockBorders
{
    private readonly LatticeMesh _mesh;
    private readonly Vector3D _start;
    private readonly Vector3D _direction;

    /// <summary>Takes the ray.</summary>
    /// <param name="mesh">Where lines and samples are.</param>
    /// <param name="start">m, MOON_ME: where a piece's parameter is 0.</param>
    /// <param name="direction">Unit vector, MOON_ME.</param>
    public BlockBorders(LatticeMesh mesh, Vector3D start, Vector3D direction)
    {
        _mesh = mesh;
        _start = start;
        _direction = direction;
    }

    /// <summary>Widest block that two planes through the axis can bound well, in degrees.</summary>
    public static int WidestDegrees => 90;

    /// <summary>The part of a piece between the block's western and eastern border.</summary>
    public RayPiece CutAtMeridians(CellRectangle block, RayPiece piece)
    {
        if (block.Columns > WidestDegrees * _mesh.PixelsPerDegree)
        {
            return piece;
        }

        SineCosine west = _mesh.Longitude(block.Column);
        SineCosine east = _mesh.Longitude(block.Column + block.Columns);
        return Cut(Cut(piece, new Vector3D(-west.Sine, west.Cosine, 0.0)), new Vector3D(east.Sine, -east.Cosine, 0.0));
    }

    /// <summary>
    /// The part of a piece between the block's northern and southern border; the block is at most <see cref="WidestDegrees"/> wide.
    /// </summary>
    public RayPiece CutAtParallels(CellRectangle block, RayPiece piece)
    {
        SineCosine west = _mesh.Longitude(block.Column);
        SineCosine east = _mesh.Longitude(block.Column + block.Columns);

        // Towards the block's middle; the length is the cosine of half its width, by which the normals below are shortened too.
        double x = 0.5 * (west.Cosine + east.Cosine);
        double y = 0.5 * (west.Sine + east.Sine);
        double squaredCosine = (x * x) + (y * y);
        double cosine = Math.Sqrt(squaredCosine);
        SineCosine north = _mesh.Latitude(block.Row - 1);
        SineCosine south = _mesh.Latitude(block.Row + block.Rows - 1);
        double northZ = north.Cosine * (north.Sine >= 0.0 ? squaredCosine : cosine);
        double southZ = south.Cosine * (south.Sine >= 0.0 ? cosine : squaredCosine);
        return Cut(
            Cut(piece, new Vector3D(north.Sine * x, north.Sine * y, -northZ)),
            new Vector3D(-south.Sine * x, -south.Sine * y, southZ));
    }

    private RayPiece Cut(RayPiece piece, Vector3D inwardNormal) => piece.WhereNotNegative(
        Vector3D.Dot(inwardNormal, _start) + Tolerances.VertexLattice, Vector3D.Dot(inwardNormal, _direction));
}
