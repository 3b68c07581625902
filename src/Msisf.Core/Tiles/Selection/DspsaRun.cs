using Msisf.Core.Camera;
using Msisf.Core.Numerics;
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
    private readonly PolarView _view;
    private readonly HorizonMap _horizon;
    private readonly SurfaceWalk _walk;
    private readonly TerrainPatch _patch;
    private readonly Vector3D? _sunPosition;
    private readonly TileReason[] _reasons = new TileReason[TileId.Count];
    private readonly bool[] _kept = new bool[TileId.Count];
    private readonly bool[] _seen = new bool[TileId.Count];

    /// <param name="frame">View frustum of the image, from a camera above the surface.</param>
    /// <param name="sunPositionMoonMe">m, MOON_ME; null for a light at the camera.</param>
    /// <param name="grid">The model.</param>
    /// <param name="summary">Of the same model.</param>
    /// <param name="slack">rad: ground that is hidden by less than this angle counts as seen.</param>
    public DspsaRun(
        ViewFrustum frame,
        Vector3D? sunPositionMoonMe,
        IGlobalGrid grid,
        ElevationSummary summary,
        double slack = 0.0)
    {
        _summary = summary;
        _tiles = summary.Levels[0];
        _frame = frame;
        _view = new PolarView(frame.CameraMoonMe);
        _sunPosition = sunPositionMoonMe;

        // There are two patches, because a walk still reads its own while a visitor loads another.
        FacetMesh mesh = new(grid);
        _patch = new TerrainPatch(mesh);
        HorizonSurvey survey = new(_view, summary, _patch);
        (double middle, double width) = FrameAzimuths();
        _horizon = survey.EmptyMap(middle, width);
        survey.Fill(_horizon, (in TerrainNode node, in PolarBounds _) => _frame.Classify(node.Ball()) != FrustumSide.Outside);
        _walk = new SurfaceWalk(summary, _frame, _view, _horizon, new TerrainPatch(mesh), slack);
    }

    /// <summary>The Moon from the Sun; null before the selection, and for a light at the camera.</summary>
    public SunView? Sun { get; private set; }

    /// <summary>Buffer for reading terrain; not the one that a walk uses.</summary>
    public TerrainPatch Patch => _patch;

    /// <summary>Whether the selection found that some of a tile may be seen, lit or dark.</summary>
    public bool IsSeen(TileId tile) => _seen[tile.Number];

    /// <summary>Bounds of the tiles from the camera.</summary>
    public PolarView View => _view;

    /// <summary>Prepares to ask what lies behind pieces of some tiles.</summary>
    public OccluderVisitor CoverOf(IReadOnlyList<TileId> tiles) =>
        new(_summary, _frame, new BoundsTable(_view, _summary), _patch, tiles);

    /// <summary>Nodes of the summary's tree that were entered so far.</summary>
    public int NodesVisited => _walk.NodesVisited;

    /// <summary>Walks the surface of a tile that may be seen.</summary>
    public void Walk(TileId tile, ISurfaceVisitor visitor) => _walk.Walk(tile, visitor);

    /// <summary>Does the selection.</summary>
    public TileSelection Select()
    {
        List<TileId> inFrame = TilesInFrame();
        SunView? sun = _sunPosition is Vector3D position
            ? new SunView(position, _summary, _patch, inFrame.Where(tile => !IsHidden(tile)))
            : null;
        Sun = sun;
        List<TileId> newlyKept = [];
        List<TileId> dark = [];
        FindVisible(inFrame, sun, newlyKept, dark);
        if (sun is not null)
        {
            KeepWhatIsNeeded(sun, newlyKept, dark);
        }

        return new TileSelection(TileId.All.Zip(_reasons, (tile, reason) => new TileChoice(tile, reason)));
    }

    /// <summary>The range of azimuths that the image covers, about the line from camera to Moon's centre.</summary>
    private (double Middle, double Width) FrameAzimuths()
    {
        Vector3D up = _view.Axis;
        if (_frame.Contains(up) || _frame.Contains(-up))
        {
            return (0.0, 2.0 * Math.PI);
        }

        // The image is a convex cone without the axis, so less than half a turn, and its edges bound it.
        double middle = _view.AzimuthOf(_frame.Middle);
        double min = 0.0;
        double max = 0.0;
        foreach (Vector3D edge in _frame.Edges)
        {
            double turn = AzimuthWindow.Wrapped(_view.AzimuthOf(edge) - middle);
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
        TileId[] possible = [.. TileId.FromNorth.Where(
            tile => !_summary.IsOnDemand || MayBeSeen(0, tile.RowFromNorth, tile.Column, ref _reasons[tile.Number]))];
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
            if (_walk.IsHidden(_view.Bounds(unread)))
            {
                return true;
            }

            if (!_walk.IsHidden(_view.Bounds(unread with { MaxRadius = unread.MinRadius })))
            {
                return false;
            }
        }

        return _walk.IsHidden(_view.Bounds(_tiles.NodeOf(tile)));
    }

    /// <summary>
    /// Whether a node may be seen with any heights that the model may have: whether one of its finest nodes may. Nothing is read.
    /// </summary>
    private bool MayBeSeen(int depth, int row, int column, ref TileReason reason)
    {
        SummaryLevel level = _summary.Levels[depth];
        TerrainNode node = level.NodeOfLimits(row, column);
        FrustumSide side = _frame.Classify(node.Ball());
        if (side == FrustumSide.Outside)
        {
            return false;
        }

        if (_walk.IsHidden(_view.Bounds(node)))
        {
            reason = TileReason.Hidden;
            return false;
        }

        if (depth + 1 == _summary.Levels.Count)
        {
            return true;
        }

        int factor = _summary.Levels[depth + 1].Subdivisions / level.Subdivisions;
        for (int child = 0; child < factor * factor; child++)
        {
            if (MayBeSeen(depth + 1, (row * factor) + (child / factor), (column * factor) + (child % factor), ref reason))
            {
                return true;
            }
        }

        return false;
    }

    private void FindVisible(List<TileId> inFrame, SunView? sun, List<TileId> newlyKept, List<TileId> dark)
    {
        VisibleTileVisitor visitor = new(sun);
        foreach (TileId tile in inFrame)
        {
            visitor.Reset();
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
        ShadowCasterVisitor casters = new(sun, _summary, _patch, _kept, newlyKept);
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
                cover.Reset();
                if (round <= MaxCloseRounds || !cover.MayLeaveBeforeLimb(tile))
                {
                    Walk(tile, cover);
                }

                if (cover.Covers || (round > MaxCloseRounds && cover.MayLeaveBeforeLimb(tile)))
                {
                    _kept[tile.Number] = true;
                    _reasons[tile.Number] = TileReason.DarkButCovering;
                    newlyKept.Add(tile);
                }
            }
        }
    }
}
