using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>One selection of tiles, and the walks over the surface that the image may show.</summary>
internal sealed class DspsaRun
{
    /// <summary>
    /// Maximum number of rounds that test exactly what dark tiles hide; after these, all dark tiles that may hide each other in a chain
    /// along the limb are kept.
    /// </summary>
    private const int MaxCloseRounds = 1;

    private readonly ElevationSummary _summary;
    private readonly SummaryLevel _tiles;
    private readonly ViewFrustum _frame;
    private readonly SightWalk _walk;
    private readonly Vector3D? _sunPosition;
    private readonly TileReason[] _reasons = new TileReason[TileId.Count];
    private readonly bool[] _kept = new bool[TileId.Count];
    private readonly bool[] _seen = new bool[TileId.Count];

    /// <param name="frame">View frustum of the image, from a camera above the surface.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null for a light at the camera.</param>
    /// <param name="grid">The model.</param>
    /// <param name="summary">Of the same model.</param>
    /// <param name="slack">rad: ground that is hidden by less than this angle counts as seen.</param>
    public DspsaRun(
        ViewFrustum frame, Vector3D? sunPositionBodyFixed, IGlobalGrid grid, ElevationSummary summary, double slack = 0.0)
    {
        (_summary, _tiles, _frame, _sunPosition) = (summary, summary.Levels[0], frame, sunPositionBodyFixed);
        View = new PolarView(frame.CameraBodyFixed);

        // There are two patches, because a walk still reads its own while a visitor loads another.
        FacetMesh mesh = new(grid);
        Patch = new TerrainPatch(mesh);
        HorizonSurvey survey = new(View, summary, Patch);
        (double middle, double width) = FrameAzimuths();
        HorizonMap horizon = survey.EmptyMap(middle, width);
        survey.Fill(horizon, (in TerrainNode node, in PolarBounds _) => _frame.Classify(node.Ball()) != FrustumSide.Outside);
        _walk = new SightWalk(summary, _frame, View, horizon, new TerrainPatch(mesh), slack);
    }

    /// <summary>The Moon from the Sun; null before the selection, and for a light at the camera.</summary>
    public SunView? Sun { get; private set; }

    /// <summary>Buffer for reading terrain; not the one that a walk uses.</summary>
    public TerrainPatch Patch { get; }

    /// <summary>Whether the selection found that some of a tile may be seen, lit or dark.</summary>
    public bool IsSeen(TileId tile) => _seen[tile.Number];

    /// <summary>Bounds of the tiles from the camera.</summary>
    public PolarView View { get; }

    /// <summary>Prepares to ask what lies behind pieces of some tiles.</summary>
    public OccluderVisitor CoverOf(IReadOnlyList<TileId> tiles) =>
        new(_summary, _frame, new BoundsTable(View, _summary), Patch, tiles);

    /// <summary>Nodes of the summary's tree that were entered so far.</summary>
    public int NodesVisited => _walk.NodesVisited;

    /// <summary>Walks the surface of a tile that may be seen.</summary>
    public void Walk(TileId tile, ISightVisitor visitor) => _walk.Walk(tile, visitor);

    /// <summary>Does the selection.</summary>
    public TileSelection Select()
    {
        List<TileId> inFrame = TilesInFrame();
        Sun = _sunPosition is Vector3D position
            ? new SunView(position, _summary, Patch, inFrame.Where(tile => !IsHidden(tile)))
            : null;
        List<TileId> newlyKept = [];
        List<TileId> dark = [];
        FindVisible(inFrame, newlyKept, dark);
        if (Sun is { } sun)
        {
            KeepWhatIsNeeded(sun, newlyKept, dark);
        }

        return new TileSelection(TileId.All.Zip(_reasons, (tile, reason) => new TileChoice(tile, reason)));
    }

    /// <summary>The range of azimuths that the image covers, about the line from camera to Moon's centre.</summary>
    private (double Middle, double Width) FrameAzimuths()
    {
        Vector3D up = View.Axis;
        if (_frame.Contains(up) || _frame.Contains(-up))
        {
            return (0.0, 2.0 * Math.PI);
        }

        // The image is a convex cone without the axis, so less than half a turn, and its edges bound it.
        double middle = View.AzimuthOf(_frame.Middle);
        double min = 0.0;
        double max = 0.0;
        foreach (Vector3D edge in _frame.Edges)
        {
            double turn = AzimuthWindow.Wrapped(View.AzimuthOf(edge) - middle);
            min = Math.Min(min, turn);
            max = Math.Max(max, turn);
        }

        // Where the axis is on the border of the image, rounding decides between a half turn and more.
        double width = max - min + (2.0 * Tolerances.WindowMargin);
        return width < 0.9 * Math.PI ? (middle + (0.5 * (min + max)), width) : (0.0, 2.0 * Math.PI);
    }

    private List<TileId> TilesInFrame()
    {
        Array.Fill(_reasons, TileReason.OutsideFrame);
        TileId[] possible = [.. TileId.FromNorth.Where(tile => !_summary.IsOnDemand || MayBeSeen(tile))];
        _summary.Read(possible.Where(_walk.ReadsWhole));
        return [.. possible.Where(IsInFrame)];
    }

    /// <summary>Whether the tile's ball is in the image; it is read only if the limits of the model leave that open.</summary>
    /// <remarks>
    /// The ball is centred on the cap's axis, at a distance that lies between those of the limits, and reaches the cap's rim.
    /// </remarks>
    private bool IsInFrame(TileId tile)
    {
        TerrainNode unread = _tiles.NodeUnread(tile);
        if (unread.IsUnread)
        {
            if (_frame.Classify(unread.Ball()) == FrustumSide.Outside)
            {
                return false;
            }

            double radius = unread.MinRadius * unread.Cap.SinRadius;
            Vector3D lowest = unread.MinRadius * unread.Cap.CosRadius * unread.Cap.Centre;
            Vector3D highest = unread.MaxRadius * unread.Cap.CosRadius * unread.Cap.Centre;
            if (_frame.Classify((lowest, radius)) != FrustumSide.Outside && _frame.Classify((highest, radius)) != FrustumSide.Outside)
            {
                return true;
            }
        }

        return _frame.Classify(_tiles.NodeOf(tile).Ball()) != FrustumSide.Outside;
    }

    /// <summary>Whether the tile's bounds say that it is hidden; it is read only if the limits of the model leave that open.</summary>
    private bool IsHidden(TileId tile)
    {
        TerrainNode unread = _tiles.NodeUnread(tile);
        if (unread.IsUnread)
        {
            if (_walk.IsHidden(View.Bounds(unread)))
            {
                return true;
            }

            if (!_walk.IsHidden(View.Bounds(unread with { MaxRadius = unread.MinRadius })))
            {
                return false;
            }
        }

        return _walk.IsHidden(View.Bounds(_tiles.NodeOf(tile)));
    }

    /// <summary>
    /// Whether a tile may be seen with any heights that the model may have: whether one of its finest nodes may. Nothing is read.
    /// </summary>
    private bool MayBeSeen(TileId tile)
    {
        PossibleSight sight = new(this);
        bool isSeen = !NodeWalk.From(_summary.Layout, _summary.PlaceOf(tile), ref sight);
        _reasons[tile.Number] = sight.IsHidden ? TileReason.Hidden : TileReason.OutsideFrame;
        return isSeen;
    }

    private void FindVisible(List<TileId> inFrame, List<TileId> newlyKept, List<TileId> dark)
    {
        foreach (TileId tile in inFrame)
        {
            VisibleTileVisitor visitor = new(Sun);
            Walk(tile, visitor);
            _seen[tile.Number] = visitor.SeenLit || visitor.SeenDark;
            if (visitor.SeenLit)
            {
                _reasons[tile.Number] = TileReason.Visible;
                _kept[tile.Number] = true;
                newlyKept.Add(tile);
            }
            else if (visitor.SeenDark)
            {
                _reasons[tile.Number] = TileReason.Night;
                dark.Add(tile);
            }
            else if (_walk.MetFrame)
            {
                _reasons[tile.Number] = TileReason.Hidden;
            }
        }
    }

    /// <summary>
    /// Adds the tiles that cast shadows on kept tiles, and dark tiles that hide kept tiles, until no more tiles are needed.
    /// </summary>
    private void KeepWhatIsNeeded(SunView sun, List<TileId> newlyKept, List<TileId> dark)
    {
        ShadowCasterVisitor casters = new(sun, _summary, Patch, _kept, newlyKept);
        OccluderVisitor? cover = null;
        int done = 0;
        int coverKnows = 0;
        int round = 0;
        while (done < newlyKept.Count)
        {
            for (; done < newlyKept.Count; done++)
            {
                TileId tile = newlyKept[done];
                if (_reasons[tile.Number] is not (TileReason.Visible or TileReason.DarkButCovering))
                {
                    _reasons[tile.Number] = TileReason.CastsShadow;
                }

                if (_seen[tile.Number])
                {
                    Walk(tile, casters);
                }
            }

            cover ??= CoverOf(dark);
            cover.LookFor(newlyKept.Skip(coverKnows));
            coverKnows = newlyKept.Count;
            round++;
            foreach (TileId tile in dark.Where(tile => !_kept[tile.Number]))
            {
                bool isKeptUntested = round > MaxCloseRounds && cover.MayLeaveBeforeLimb(tile);
                if (!isKeptUntested)
                {
                    cover.Reset();
                    Walk(tile, cover);
                }

                if (isKeptUntested || cover.Covers)
                {
                    _kept[tile.Number] = true;
                    _reasons[tile.Number] = TileReason.DarkButCovering;
                    newlyKept.Add(tile);
                }
            }
        }
    }

    /// <summary>Stops at a finest node that may be seen with any heights that the model may have.</summary>
    private struct PossibleSight(DspsaRun run) : INodeTester
    {
        /// <summary>Whether a node was left out because it is hidden.</summary>
        public bool IsHidden { get; private set; }

        public Visit Test(NodePlace place)
        {
            TerrainNode node = run._summary.LevelOf(place).NodeOfLimits(place.Row, place.Column);
            if (run._frame.Classify(node.Ball()) == FrustumSide.Outside)
            {
                return Visit.Skip;
            }

            bool isHidden = run._walk.IsHidden(run.View.Bounds(node));
            IsHidden |= isHidden;
            return isHidden ? Visit.Skip : place.Level == 0 ? Visit.Stop : Visit.Descend;
        }
    }
}
