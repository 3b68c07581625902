using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Walks down a tile to its facets, leaving out nodes and facets that are outside the image or certainly hidden from the camera.
/// </summary>
internal sealed class SurfaceWalk
{
    /// <summary>Room for the corners of a triangle that is clipped by four planes: 7, and one in reserve.</summary>
    private const int MaxCorners = 8;

    private readonly ElevationSummary _summary;
    private readonly ViewFrustum _frame;
    private readonly PolarView _view;
    private readonly HorizonMap _horizon;
    private readonly Vector3D _camera;
    private readonly TerrainPatch _patch;
    private readonly double _slack;
    private bool _readsWhole;

    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="frame">The image.</param>
    /// <param name="view">Half planes of the camera.</param>
    /// <param name="horizon">What the terrain hides from the camera.</param>
    /// <param name="patch">Buffer for reading terrain.</param>
    /// <param name="slack">rad: ground that is hidden by less than this angle counts as seen.</param>
    public SurfaceWalk(
        ElevationSummary summary, ViewFrustum frame, PolarView view, HorizonMap horizon, TerrainPatch patch, double slack)
    {
        _slack = slack;
        _summary = summary;
        _frame = frame;
        _view = view;
        _horizon = horizon;
        _camera = frame.CameraMoonMe;
        _patch = patch;
    }

    /// <summary>Whether the last walk met surface inside the image.</summary>
    public bool MetFrame { get; private set; }

    /// <summary>
    /// Number of nodes of the summary's tree that all walks have entered: a measure of the work that does not depend on the machine.
    /// </summary>
    public int NodesVisited { get; private set; }

    /// <summary>
    /// Whether the walk of a tile takes the exact bounds of all its nodes, for which all of it is read: where it is in the image as a
    /// whole, or all is known. Of another tile a small part may be in the image, so only nodes of the finest level are read.
    /// </summary>
    public bool ReadsWhole(TileId tile) =>
        !_summary.IsOnDemand
        || _frame.Classify(_summary.Levels[0].NodeOfLimits(tile.RowFromNorth, tile.Column).Ball()) == FrustumSide.Inside;

    /// <summary>Walks one tile.</summary>
    public void Walk(TileId tile, ISurfaceVisitor visitor)
    {
        MetFrame = false;
        _readsWhole = ReadsWhole(tile);
        Enter(0, tile.RowFromNorth, tile.Column, inside: false, visitor);
    }

    /// <summary>Whether a piece of the surface is certainly hidden from the camera.</summary>
    public bool IsHidden(in PolarBounds bounds) => _horizon.Hides(_slack == 0.0 ? bounds : bounds.Raised(_slack));

    /// <summary>Bounds of a polygon; their azimuths are the whole circle if it may meet the axis.</summary>
    public static PolarBounds BoundsOf(PolarView view, ReadOnlySpan<Vector3D> polygon)
    {
        PolarPoint first = view.Project(polygon[0]);
        double near = first.Arc;
        double far = first.Arc;
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        double lowest = 0.0;
        double highest = 0.0;
        double nearest = double.PositiveInfinity;
        foreach (Vector3D corner in polygon)
        {
            PolarPoint point = view.Project(corner);
            double across = point.Across;
            double slope = point.Rise / across;
            double margin = Tolerances.VertexLattice * (1.0 + Math.Abs(slope)) / across;
            double turn = AzimuthWindow.Wrapped(point.Azimuth - first.Azimuth);
            nearest = Math.Min(nearest, across);
            near = Math.Min(near, point.Arc);
            far = Math.Max(far, point.Arc);
            min = Math.Min(min, slope - margin);
            max = Math.Max(max, slope + margin);
            lowest = Math.Min(lowest, turn);
            highest = Math.Max(highest, turn);
        }

        double half = 0.5 * (highest - lowest);
        double reach = half + (Tolerances.VertexLattice / nearest);
        double size = Math.Sqrt(
            (polygon[0] - polygon[^1]).LengthSquared + (polygon[0] - polygon[1]).LengthSquared + (polygon[0] - polygon[2]).LengthSquared);
        if (!(reach < 0.25 * Math.PI) || nearest < 3.0 * size)
        {
            // The polygon is so near to the axis that it may enclose it, or that its edges are much nearer to it than its corners.
            return new PolarBounds(
                0.0, Math.Min(1.0, far + Tolerances.CapRadius), 0.0, 2.0 * Math.PI, double.NegativeInfinity, double.PositiveInfinity);
        }

        // Between two corners a chord is nearer to the axis than both, by the cosine of half the turn at most; its arcs by far less than
        // the turn squared.
        double chord = 1.0 / Math.Cos(half);
        double bulge = half * half;
        return new PolarBounds(
            near * (1.0 - bulge),
            Math.Min(1.0, far * (1.0 + bulge)),
            first.Azimuth + (0.5 * (lowest + highest)),
            reach,
            min < 0.0 ? min * chord : min,
            max > 0.0 ? max * chord : max);
    }

    private bool Enter(int depth, int row, int column, bool inside, ISurfaceVisitor visitor)
    {
        NodesVisited++;
        SummaryLevel level = _summary.Levels[depth];
        TerrainNode node = _readsWhole || depth + 1 == _summary.Levels.Count
            ? level.Node(row, column)
            : level.NodeOfLimits(row, column);
        if (!inside)
        {
            FrustumSide side = _frame.Classify(node.Ball());
            if (side == FrustumSide.Outside)
            {
                return true;
            }

            inside = side == FrustumSide.Inside;
        }

        MetFrame |= inside;
        PolarBounds bounds = _view.Bounds(node);
        if (IsHidden(bounds))
        {
            return true;
        }

        bool certain = inside && _horizon.NeverHides(bounds);
        NodePlace place = new(depth, row, column);
        Visit wanted = visitor.Node(node, bounds, certain, place);
        if (wanted == Visit.Read)
        {
            node = level.Node(row, column);
            wanted = visitor.Node(node, _view.Bounds(node), certain, place);
        }

        if (wanted != Visit.Descend)
        {
            return wanted != Visit.Stop;
        }

        return depth + 1 == _summary.Levels.Count
            ? EnterCells(level.Cells(row, column), inside, visitor)
            : EnterChildren(depth, row, column, inside, visitor);
    }

    private bool EnterChildren(int depth, int row, int column, bool inside, ISurfaceVisitor visitor)
    {
        int factor = _summary.Levels[depth + 1].Subdivisions / _summary.Levels[depth].Subdivisions;
        for (int child = 0; child < factor * factor; child++)
        {
            if (!Enter(depth + 1, (row * factor) + (child / factor), (column * factor) + (child % factor), inside, visitor))
            {
                return false;
            }
        }

        return true;
    }

    private bool EnterCells(CellRange cells, bool inside, ISurfaceVisitor visitor)
    {
        _patch.Load(cells);
        for (int line = 0; line + 1 < _patch.Lines; line++)
        {
            for (int sample = 0; sample + 1 < _patch.Samples; sample++)
            {
                Vector3D northWest = _patch[line, sample];
                Vector3D southEast = _patch[line + 1, sample + 1];
                if (!EnterFacet(new Facet(northWest, _patch[line + 1, sample], southEast), inside, visitor)
                    || !EnterFacet(new Facet(northWest, southEast, _patch[line, sample + 1]), inside, visitor))
                {
                    return false;
                }
            }
        }

        return true;
    }

    private bool EnterFacet(in Facet facet, bool inside, ISurfaceVisitor visitor)
    {
        if (MetFrame && facet.TurnsAwayFrom(_camera))
        {
            return true;
        }

        Span<Vector3D> part = stackalloc Vector3D[MaxCorners];
        part[0] = facet.A;
        part[1] = facet.B;
        part[2] = facet.C;
        int count = 3;
        if (!inside)
        {
            _frame.Clip(part, ref count);
            if (count < 3)
            {
                return true;
            }

            MetFrame = true;
            if (facet.TurnsAwayFrom(_camera))
            {
                return true;
            }
        }

        PolarBounds bounds = BoundsOf(_view, part[..count]);
        return IsHidden(bounds) || visitor.Facet(part[..count], bounds, facet) != Visit.Stop;
    }
}
