using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tracing;

/// <summary>
/// Walks one ray through the surface: into ever smaller rectangles of cells, nearest first, down to the facet through which the ray enters
/// the ground. Pieces of the ray, in m from its nearest approach to the Moon's centre, only select the cells to test. Hits are decided on
/// <see cref="_near"/>.
/// </summary>
internal ref struct RayWalk
{
    private readonly SurfaceModel _surface;
    private readonly bool _stopsAtAnyHit;
    private readonly Ray _near;
    private readonly double _offset;
    private readonly EdgeFunction _edge;
    private readonly double _length;
    private readonly double _startParameter;
    private readonly Vector3D _start;
    private readonly double _startSquared;
    private readonly double _startRise;
    /// <summary>m: a radius that is above the whole surface.</summary>
    private readonly double _top;

    private readonly double _bottom;
    private readonly Vector3D _unitDirection;
    private GridPatch _part;
    private int _partNumber;
    private CellWedge _wedge;
    private double _sagitta;
    private double _parameter;
    private double _farthest;

    /// <summary>Prepares a walk.</summary>
    /// <param name="ray">The ray, body-fixed; it must be finite and have a direction.</param>
    /// <param name="endParameter">Hits at this parameter of the ray or beyond do not count.</param>
    /// <param name="stopsAtAnyHit">Whether the walk stops at any hit instead of finding the first one.</param>
    public RayWalk(SurfaceModel surface, Ray ray, double endParameter, bool stopsAtAnyHit)
    {
        _surface = surface;
        _stopsAtAnyHit = stopsAtAnyHit;
        _top = surface.ReferenceRadius + MoonConstants.MaxReliefOver(surface.ReferenceRadius) + 1.0;
        (_near, _offset) = ShiftedRay.From(ray, _top);
        _length = ray.Direction.Length;
        Vector3D direction = ray.Direction / _length;
        _startParameter = -Vector3D.Dot(_near.Origin, direction);
        _start = _near.Origin + (_startParameter * direction);
        _startSquared = _start.LengthSquared;
        _startRise = Vector3D.Dot(_start, direction);
        _edge = new EdgeFunction(_near.Origin, ray.Direction);
        _unitDirection = direction;
        _part = surface.Parts[0];
        _sagitta = _part.Geometry.Sagitta;
        _bottom = surface.SolidRadius(
            surface.ReferenceRadius - MoonConstants.MaxReliefOver(surface.ReferenceRadius) - 1.0);
        _parameter = endParameter - _offset;
        _farthest = PlaceOf(_parameter) + Tolerances.VertexLattice;
    }

    /// <summary>Parameter of the hit on the original ray.</summary>
    public readonly double Parameter => _offset + _parameter;

    /// <summary>The point that is hit, m, body-fixed.</summary>
    public readonly Vector3D Point => _near.Origin + (_parameter * _near.Direction);

    /// <summary>The facet that is hit; null if none has been hit.</summary>
    public FacetId? Facet { get; private set; }

    /// <summary>Outward normal of the facet that is hit, body-fixed; its length is not 1.</summary>
    public Vector3D Normal { get; private set; }

    private readonly bool IsOver => _stopsAtAnyHit && Facet is not null;

    /// <summary>Walks along the ray until the hit is certain.</summary>
    public void Run()
    {
        double distance = _start.Length;
        if (distance < _top)
        {
            double origin = PlaceOf(-_offset);
            double halfChord = HalfChord(_top, distance);
            RayPiece piece = new(Math.Max(-halfChord, origin - Tolerances.VertexLattice), Math.Min(halfChord, _farthest));
            if (origin < 0.0 && distance < _bottom)
            {
                // The piece ends below the whole surface, where the ray has certainly entered the ground: near the Moon's centre the wedges
                // of all cells would meet.
                piece = piece with { Far = Math.Min(piece.Far, -HalfChord(_bottom, distance)) };
            }

            for (_partNumber = 0; _partNumber < _surface.Parts.Count; _partNumber++)
            {
                _part = _surface.Parts[_partNumber];
                if (_part.IsLeftOut)
                {
                    continue;
                }

                _wedge = new CellWedge(_part.Geometry, _start, _unitDirection);
                _sagitta = _part.Geometry.Sagitta;
                VisitIfMet(_part.Mesh.Cells, piece, level: SquareLayout.GroupLevel);
            }

            VisitSeams(piece);
        }
    }

    /// <summary>Tests the facets between models whose balls the ray meets.</summary>
    private void VisitSeams(RayPiece piece)
    {
        SeamPatch seams = _surface.Seams;
        for (int number = 0; number < seams.Blocks.Count && !IsOver; number++)
        {
            (Vector3D centre, double radius) = seams.Blocks[number].Ball;
            Vector3D away = centre - _start;
            double along = Vector3D.Dot(away, _unitDirection);
            if (along + radius < piece.Near || along - radius > Math.Min(piece.Far, _farthest)
                || (away - (along * _unitDirection)).LengthSquared > radius * radius)
            {
                continue;
            }

            int first = number * SeamPatch.BlockFacets;
            for (int facet = first; facet < first + seams.FacetsOf(number); facet++)
            {
                (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(facet);
                double last = _edge.Of(c, a);
                if (last >= 0.0)
                {
                    TryFacet(new FacetId(0, facet, FacetHalf.SouthWest) { Part = _partNumber }, a, b, c, _edge.Of(a, b), last);
                }
            }
        }
    }

    /// <summary>Half the length, m, of the chord of a sphere at a distance from its centre.</summary>
    private static double HalfChord(double radius, double distance) => Math.Sqrt((radius - distance) * (radius + distance));

    /// <summary>
    /// Converts a parameter of the shifted ray to the scale of the pieces, m from the nearest approach to the Moon's centre.
    /// </summary>
    private readonly double PlaceOf(double parameter) => (parameter * _length) - _startParameter;

    private void VisitIfMet(CellRange cells, RayPiece piece, int level)
    {
        if (!piece.IsEmpty && piece.Near <= _farthest && !IsOver)
        {
            Visit(cells, piece with { Far = Math.Min(piece.Far, _farthest) }, level);
        }
    }

    /// <summary>
    /// Tests a rectangle of cells for which the bounds of the levels above <paramref name="level"/> have already been tested.
    /// </summary>
    private void Visit(CellRange cells, RayPiece piece, int level)
    {
        int size = Math.Max(cells.Lines, cells.Samples);
        for (; level >= SquareLayout.PatchLevel && size <= SquareLayout.Side(level); level--)
        {
            int shift = SquareLayout.SideShift(level);
            CellRange all = _part.Mesh.Cells;
            int row = (cells.FirstLine - all.FirstLine) >> shift;
            int column = (cells.FirstSample - all.FirstSample) >> shift;
            if (level == SquareLayout.CellBlockLevel && _part.Kept?.StateOf(row, column) == CellMask.BlockState.Empty)
            {
                return;
            }

            NodeBounds bounds = _part.Bounds.Of(level, row, column);
            if (!MayMeet(piece, bounds.Min, bounds.Max))
            {
                return;
            }
        }

        if (size == 1)
        {
            VisitCell(cells.FirstLine, cells.FirstSample, piece);
            return;
        }

        bool cutsAlongMeridian = cells.Samples >= cells.Lines || cells.Samples > _part.Geometry.WidestColumns;
        (CellRange first, CellRange second) = cutsAlongMeridian ? cells.CutAlongMeridian() : cells.CutAlongParallel();
        RayPiece firstPiece = cutsAlongMeridian ? _wedge.CutAtColumns(first, piece) : _wedge.CutAtLines(first, piece);
        RayPiece secondPiece = cutsAlongMeridian ? _wedge.CutAtColumns(second, piece) : _wedge.CutAtLines(second, piece);
        if (secondPiece.Near < firstPiece.Near)
        {
            (first, second) = (second, first);
            (firstPiece, secondPiece) = (secondPiece, firstPiece);
        }

        VisitIfMet(first, firstPiece, level);
        VisitIfMet(second, secondPiece, level);
    }

    /// <summary>Whether a piece of the ray reaches the heights of facets whose vertex radii lie within limits (m).</summary>
    private readonly bool MayMeet(RayPiece piece, double min, double max)
    {
        double top = max + Tolerances.VertexLattice;
        double bottom = (min - Tolerances.VertexLattice) * _sagitta;
        return SquaredRadiusAt(Math.Clamp(-_startRise, piece.Near, piece.Far)) <= top * top
            && Math.Max(SquaredRadiusAt(piece.Near), SquaredRadiusAt(piece.Far)) >= bottom * bottom;
    }

    private readonly double SquaredRadiusAt(double s) => _startSquared + (s * ((2.0 * _startRise) + s));

    private void VisitCell(int line, int sample, RayPiece piece)
    {
        if (!_part.Has(line, sample))
        {
            return;
        }

        Span<double> radii = stackalloc double[4];
        _part.ReadCorners(line, sample, radii);
        double min = Math.Min(Math.Min(radii[0], radii[1]), Math.Min(radii[2], radii[3]));
        double max = Math.Max(Math.Max(radii[0], radii[1]), Math.Max(radii[2], radii[3]));
        if (!MayMeet(piece, min, max))
        {
            return;
        }

        CellCorners corners = _part.Corners(line, sample, radii);
        double diagonal = _edge.Of(corners.NorthWest, corners.SouthEast);
        if (diagonal <= 0.0 && line < _part.Mesh.SouthFanLine)
        {
            TryHalf(new FacetId(line, sample, FacetHalf.SouthWest) { Part = _partNumber }, corners, -diagonal);
        }

        if (diagonal >= 0.0 && line >= 0)
        {
            TryHalf(new FacetId(line, sample, FacetHalf.NorthEast) { Part = _partNumber }, corners, diagonal);
        }
    }

    private void TryHalf(FacetId facet, in CellCorners corners, double diagonal)
    {
        (Vector3D a, Vector3D b, Vector3D c) = corners.Facet(facet.Half);
        TryFacet(facet, a, b, c, facet.Half == FacetHalf.SouthWest ? _edge.Of(a, b) : _edge.Of(c, a), diagonal);
    }

    /// <summary>Records a facet as the hit if the ray enters the ground through it and it is nearer than the hit found before.</summary>
    /// <param name="a">Its first corner.</param>
    /// <param name="b">Its second corner.</param>
    /// <param name="c">Its third corner.</param>
    /// <param name="second">Edge function of one of the edges at the first corner.</param>
    /// <param name="diagonal">Edge function of the other one, which is not below 0.</param>
    private void TryFacet(FacetId facet, Vector3D a, Vector3D b, Vector3D c, double second, double diagonal)
    {
        double third = _edge.Of(b, c);

        // All three are 0 for a facet without area and for one that the ray sees edge-on: the ray enters through its neighbours instead.
        if (!(second >= 0.0 && third >= 0.0 && diagonal + second + third > 0.0))
        {
            return;
        }

        Vector3D normal = Vector3D.Cross(b - a, c - a);
        double parameter = ParameterOn(normal, a, b, c);
        if (parameter > -_offset && parameter < _parameter)
        {
            _parameter = parameter;
            _farthest = PlaceOf(parameter) + Tolerances.VertexLattice;
            Facet = facet;
            Normal = normal;
        }
    }

    /// <summary>
    /// Parameter at which the ray meets a facet's plane. If the facet is nearly edge-on, the quotient is limited to the range of the
    /// facet's corners.
    /// </summary>
    private readonly double ParameterOn(Vector3D normal, Vector3D a, Vector3D b, Vector3D c)
    {
        double alongA = AlongRay(a);
        double alongB = AlongRay(b);
        double alongC = AlongRay(c);
        double parameter = Vector3D.Dot(normal, a - _near.Origin) / Vector3D.Dot(normal, _near.Direction);
        double first = Math.Min(alongA, Math.Min(alongB, alongC));
        double last = Math.Max(alongA, Math.Max(alongB, alongC));
        return parameter >= first ? Math.Min(parameter, last) : first;
    }

    private readonly double AlongRay(Vector3D vertex) =>
        Vector3D.Dot(vertex - _near.Origin, _near.Direction) / (_length * _length);
}
