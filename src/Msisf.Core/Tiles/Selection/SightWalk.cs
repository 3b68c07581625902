using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Receives the nodes and facets that may be seen, from <see cref="SightWalk"/>, coarse nodes before fine ones.</summary>
internal interface ISightVisitor
{
    /// <summary>A node that may be seen.</summary>
    Visit Node(in SeenNode seen);

    /// <summary>A facet that may be seen.</summary>
    /// <param name="part">Part of the facet that is in the image, a convex polygon; m, body-fixed.</param>
    /// <param name="bounds">Bounds of this part from the camera.</param>
    /// <param name="facet">The whole facet.</param>
    Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet);
}

/// <summary>A node that may be seen.</summary>
/// <param name="Node">
/// Its cap and bounds. Those of a node that is not of the finest level may be the model's limits (<see cref="TerrainNode.IsUnread"/>), so
/// that it is not read where its parts can be asked.
/// </param>
/// <param name="Bounds">Bounds of the node from the camera.</param>
/// <param name="IsCertain">Whether it is certainly seen: wholly in the image, and too near for the horizon map to hide it.</param>
/// <param name="Place">Its place in the summary's tree.</param>
internal readonly record struct SeenNode(TerrainNode Node, PolarBounds Bounds, bool IsCertain, NodePlace Place);

/// <summary>
/// Walks down a tile to its facets, leaving out nodes and facets that are outside the image or certainly hidden from the camera.
/// </summary>
/// <param name="summary">Bounds of the terrain.</param>
/// <param name="view">Half planes of the camera.</param>
/// <param name="horizon">What the terrain hides from the camera.</param>
/// <param name="patch">Buffer for reading terrain.</param>
/// <param name="slack">rad: ground that is hidden by less than this angle counts as seen.</param>
internal sealed class SightWalk(
    ElevationSummary summary, ViewFrustum frame, PolarView view, HorizonMap horizon, TerrainPatch patch, double slack)
{
    /// <summary>Room for the corners of a triangle that is clipped by four planes: 7, and one in reserve.</summary>
    private const int MaxCorners = 8;

    private bool _readsWhole;

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
    public bool ReadsWhole(TileId tile) => !summary.IsOnDemand
        || frame.Classify(summary.Levels[0].NodeOfLimits(tile.RowFromNorth, tile.Column).Ball()) == FrustumSide.Inside;

    public void Walk(TileId tile, ISightVisitor visitor)
    {
        MetFrame = false;
        _readsWhole = ReadsWhole(tile);
        Nodes nodes = new(this, visitor);
        NodeWalk.From(summary.Layout, summary.PlaceOf(tile), ref nodes);
    }

    /// <summary>Whether a piece of the surface is certainly hidden from the camera.</summary>
    public bool IsHidden(in PolarBounds bounds) => horizon.Hides(slack == 0.0 ? bounds : bounds.Raised(slack));

    private Visit Enter(NodePlace place, ref int insideLevel, ISightVisitor visitor)
    {
        NodesVisited++;
        bool isFinest = place.Level == 0;
        SummaryLevel level = summary.LevelOf(place);
        TerrainNode node = _readsWhole || isFinest ? level.Node(place.Row, place.Column) : level.NodeOfLimits(place.Row, place.Column);
        bool isInside = place.Level < insideLevel;
        if (!isInside)
        {
            FrustumSide side = frame.Classify(node.Ball());
            if (side == FrustumSide.Outside)
            {
                return Visit.Skip;
            }

            isInside = side == FrustumSide.Inside;
            insideLevel = isInside ? place.Level : 0;
        }

        MetFrame |= isInside;
        PolarBounds bounds = view.Bounds(node);
        if (IsHidden(bounds))
        {
            return Visit.Skip;
        }

        Visit wanted = visitor.Node(new SeenNode(node, bounds, isInside && horizon.NeverHides(bounds), place));
        return wanted == Visit.Descend && isFinest ? EnterFacets(level.Cells(place.Row, place.Column), isInside, visitor) : wanted;
    }

    private Visit EnterFacets(CellRange cells, bool isInside, ISightVisitor visitor)
    {
        patch.Load(cells);
        for (int line = 0; line + 1 < patch.Lines; line++)
        {
            for (int sample = 0; sample + 1 < patch.Samples; sample++)
            {
                (Facet southWest, Facet northEast) = Facet.OfCell(patch, line, sample);
                if (EnterFacet(southWest, isInside, visitor) == Visit.Stop || EnterFacet(northEast, isInside, visitor) == Visit.Stop)
                {
                    return Visit.Stop;
                }
            }
        }

        return Visit.Skip;
    }

    private Visit EnterFacet(in Facet facet, bool isInside, ISightVisitor visitor)
    {
        if (MetFrame && facet.TurnsAwayFrom(frame.CameraBodyFixed))
        {
            return Visit.Skip;
        }

        Span<Vector3D> part = stackalloc Vector3D[MaxCorners];
        (part[0], part[1], part[2]) = facet;
        int count = 3;
        if (!isInside)
        {
            frame.Clip(part, ref count);
            if (count < 3)
            {
                return Visit.Skip;
            }

            bool isTested = MetFrame;
            MetFrame = true;
            if (!isTested && facet.TurnsAwayFrom(frame.CameraBodyFixed))
            {
                return Visit.Skip;
            }
        }

        PolarBounds bounds = view.Bounds(part[..count]);
        return IsHidden(bounds) ? Visit.Skip : visitor.Facet(part[..count], bounds, facet);
    }

    /// <summary>The nodes of a tile; those inside a node that is wholly in the image need no test of it.</summary>
    private struct Nodes(SightWalk walk, ISightVisitor visitor) : INodeTester
    {
        private int _insideLevel;

        public Visit Test(NodePlace node) => walk.Enter(node, ref _insideLevel, visitor);
    }
}
