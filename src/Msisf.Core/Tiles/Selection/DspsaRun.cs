using Msisf.Core.Camera;
using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>One selection. Tiles are numbered by row (0 northernmost) times columns plus column.</summary>
internal sealed class DspsaRun
{
    /// <summary>So many rounds look closely at what dark tiles cover; then all that may be links of a chain along the limb are kept.</summary>
    private const int MaxCloseRounds = 1;

    /// <summary>px: antialiasing's jitter stays within a pixel.</summary>
    private const double AntialiasingPixels = 1.0;

    private readonly ElevationSummary _summary;
    private readonly SummaryLevel _tiles;
    private readonly FramePyramid _frame;
    private readonly PolarView _view;
    private readonly HorizonMap _horizon;
    private readonly SurfaceWalk _walk;
    private readonly TerrainPatch _patch;
    private readonly Vector3D _camera;
    private readonly Vector3D? _sunPosition;
    private readonly TileReason[] _reasons = new TileReason[TileId.Count];
    private readonly bool[] _kept = new bool[TileId.Count];
    private readonly bool[] _seen = new bool[TileId.Count];

    /// <param name="camera">The camera, above the surface.</param>
    /// <param name="sunPositionMoonMe">m, MOON_ME; null for a light at the camera.</param>
    /// <param name="grid">The model.</param>
    /// <param name="summary">Of the same model.</param>
    /// <param name="marginPixels">So much wider is the image taken to be on each side.</param>
    /// <param name="slack">rad: what is hidden by less than this counts as seen.</param>
    /// <param name="rows">The rows that matter; null for the whole image.</param>
    public DspsaRun(
        PinholeCamera camera,
        Vector3D? sunPositionMoonMe,
        IElevationGrid grid,
        ElevationSummary summary,
        double marginPixels = AntialiasingPixels,
        double slack = 0.0,
        PixelRows? rows = null)
    {
        _summary = summary;
        _tiles = summary.Levels[0];
        _frame = new FramePyramid(camera, marginPixels, rows);
        _view = new PolarView(camera.PositionMoonMe);
        _sunPosition = sunPositionMoonMe;
        _camera = camera.PositionMoonMe;

        // Two patches: a walk still reads its own while a visitor loads another.
        FacetMesh mesh = new(grid);
        _patch = new TerrainPatch(mesh);
        HorizonSurvey survey = new(_view, summary, _patch);
        (double middle, double width) = FrameAzimuths();
        _horizon = survey.EmptyMap(middle, width);
        survey.Fill(_horizon, (in TerrainNode node, in PolarBounds _) => _frame.Classify(node) != FrameSide.Outside);
        _walk = new SurfaceWalk(summary, _frame, _view, _horizon, camera.PositionMoonMe, new TerrainPatch(mesh), slack);
    }

    /// <summary>The Moon from the Sun; null before the selection, and for a light at the camera.</summary>
    public SunView? Sun { get; private set; }

    /// <summary>For reading; not the one that a walk reads.</summary>
    public TerrainPatch Patch => _patch;

    /// <summary>Number of a tile.</summary>
    public static int NumberOf(TileId tile) =>
        ((((90 - tile.SouthDegrees) / TileId.SizeDegrees) - 1) * TileId.Columns) + (tile.WestDegrees / TileId.SizeDegrees);

    /// <summary>Whether the selection found something of a tile that may be seen, lit or dark.</summary>
    public bool IsSeen(TileId tile) => _seen[NumberOf(tile)];

    /// <summary>From the camera.</summary>
    public PolarView View => _view;

    /// <summary>Prepares the question what lies behind pieces of some tiles.</summary>
    public CoverVisitor CoverOf(IReadOnlyList<int> tiles) =>
        new(_summary, _frame, new BoundsTable(_view, _summary), _camera, _patch, tiles);

    /// <summary>Nodes of the summary's tree that were entered so far.</summary>
    public int NodesVisited => _walk.NodesVisited;

    /// <summary>Walks what may be seen of a tile.</summary>
    public void Walk(int tile, ISurfaceVisitor visitor) => _walk.Walk(tile / TileId.Columns, tile % TileId.Columns, visitor);

    /// <summary>Does the selection.</summary>
    public TileSelection Select()
    {
        List<int> inFrame = TilesInFrame();
        SunView? sun = _sunPosition is Vector3D position
            ? new SunView(position, _summary, _patch, inFrame.Where(tile => !_walk.IsHidden(_view.Bounds(_tiles.NodeOf(tile)))))
            : null;
        Sun = sun;
        List<int> newlyKept = [];
        List<int> dark = [];
        FindVisible(inFrame, sun, newlyKept, dark);
        if (sun is not null)
        {
            KeepWhatIsNeeded(sun, newlyKept, dark);
        }

        return new TileSelection(_reasons.Select((reason, tile) => new TileChoice(IdOf(tile), reason)));
    }

    private static TileId IdOf(int tile) =>
        new(90 - (TileId.SizeDegrees * ((tile / TileId.Columns) + 1)), TileId.SizeDegrees * (tile % TileId.Columns));

    /// <summary>The azimuths about the line to the Moon's centre that the image covers.</summary>
    private (double Middle, double Width) FrameAzimuths()
    {
        Vector3D up = _view.Axis;
        if (_frame.Holds(up) || _frame.Holds(-up))
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

    private List<int> TilesInFrame()
    {
        List<int> tiles = [];
        for (int tile = 0; tile < TileId.Count; tile++)
        {
            _reasons[tile] = TileReason.OutsideFrame;
            if (_frame.Classify(_tiles.NodeOf(tile)) != FrameSide.Outside)
            {
                tiles.Add(tile);
            }
        }

        return tiles;
    }

    private void FindVisible(List<int> inFrame, SunView? sun, List<int> newlyKept, List<int> dark)
    {
        SeenVisitor visitor = new(sun);
        foreach (int tile in inFrame)
        {
            visitor.Reset();
            Walk(tile, visitor);
            _seen[tile] = visitor.SeenLit || visitor.SeenDark;
            if (visitor.SeenLit)
            {
                _reasons[tile] = TileReason.Visible;
                _kept[tile] = true;
                newlyKept.Add(tile);
            }
            else if (visitor.SeenDark)
            {
                _reasons[tile] = TileReason.Night;
                dark.Add(tile);
            }
            else if (_walk.MetFrame)
            {
                _reasons[tile] = TileReason.Hidden;
            }
        }
    }

    /// <summary>Adds what casts shadows on what is kept, and dark tiles that cover what is kept, until nothing more is needed.</summary>
    private void KeepWhatIsNeeded(SunView sun, List<int> newlyKept, List<int> dark)
    {
        CasterVisitor casters = new(sun, _summary, _patch, _kept, newlyKept);
        CoverVisitor? cover = null;
        int done = 0;
        int coverKnows = 0;
        int round = 0;
        while (done < newlyKept.Count)
        {
            for (; done < newlyKept.Count; done++)
            {
                int tile = newlyKept[done];
                if (_reasons[tile] is not (TileReason.Visible or TileReason.DarkButCovering))
                {
                    _reasons[tile] = TileReason.CastsShadow;
                }

                if (_seen[tile])
                {
                    Walk(tile, casters);
                }
            }

            cover ??= CoverOf(dark);
            cover.LookFor(newlyKept.Skip(coverKnows));
            coverKnows = newlyKept.Count;
            round++;
            foreach (int tile in dark.Where(tile => !_kept[tile]))
            {
                cover.Reset();
                if (round <= MaxCloseRounds || !cover.MayLeaveBeforeLimb(tile))
                {
                    Walk(tile, cover);
                }

                if (cover.Covers || (round > MaxCloseRounds && cover.MayLeaveBeforeLimb(tile)))
                {
                    _kept[tile] = true;
                    _reasons[tile] = TileReason.DarkButCovering;
                    newlyKept.Add(tile);
                }
            }
        }
    }
}
