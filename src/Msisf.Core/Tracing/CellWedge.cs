using Msisf.Core.Surface;

namespace Msisf.Core.Tracing;

/// <summary>Limits a ray to the wedge from the Moon's centre in which the facets of a rectangle of cells lie.</summary>
/// <remarks>
/// A half space that holds the vertices also holds the facets, so the borders are planes that bound the vertices. Rounding to the lattice
/// moves a vertex by up to 7 mm; with a normal of up to 1.5 that is less than <see cref="Tolerances.VertexLattice"/>.
/// </remarks>
internal readonly struct CellWedge
{
    private readonly MeshGeometry _geometry;
    private readonly Vector3D _start;
    private readonly Vector3D _direction;

    /// <summary>Prepares the cuts of a ray.</summary>
    /// <param name="geometry">Gives the borders of rectangles of cells.</param>
    /// <param name="start">Point of the ray at which a piece's position is 0, m, body-fixed.</param>
    /// <param name="direction">Unit vector, body-fixed.</param>
    public CellWedge(MeshGeometry geometry, Vector3D start, Vector3D direction)
    {
        _geometry = geometry;
        _start = start;
        _direction = direction;
    }

    /// <summary>The part of a piece between the rectangle's left and right border.</summary>
    public RayPiece CutAtColumns(CellRange cells, RayPiece piece) =>
        _geometry.TryGetColumnBorders(cells, out Vector3D west, out Vector3D east) ? Cut(Cut(piece, west), east) : piece;

    /// <summary>
    /// The part of a piece between the rectangle's upper and lower border; it is at most <see cref="MeshGeometry.WidestColumns"/> wide.
    /// </summary>
    public RayPiece CutAtLines(CellRange cells, RayPiece piece)
    {
        (Vector3D north, Vector3D south) = _geometry.LineBorders(cells);
        return Cut(Cut(piece, north), south);
    }

    private RayPiece Cut(RayPiece piece, Vector3D inwardNormal) => piece.WhereNotNegative(
        Vector3D.Dot(inwardNormal, _start) + Tolerances.VertexLattice, Vector3D.Dot(inwardNormal, _direction));
}

/// <summary>
/// A part of a ray, given by positions along it in m from its nearest approach to the Moon's centre; it is empty if <see cref="Near"/> is
/// beyond <see cref="Far"/>.
/// </summary>
/// <param name="Near">Start of the piece, m.</param>
/// <param name="Far">End of the piece, m.</param>
internal readonly record struct RayPiece(double Near, double Far)
{
    /// <summary>Whether the piece is empty.</summary>
    public bool IsEmpty => !(Near <= Far);

    private static RayPiece Nothing => new(double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The part of the piece where value + slope s is not below 0, with the position s in m.</summary>
    public RayPiece WhereNotNegative(double value, double slope)
    {
        if (slope > 0.0)
        {
            return this with { Near = Math.Max(Near, -value / slope) };
        }

        if (slope < 0.0)
        {
            return this with { Far = Math.Min(Far, -value / slope) };
        }

        return value >= 0.0 ? this : Nothing;
    }
}
