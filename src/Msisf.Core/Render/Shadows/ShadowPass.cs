using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Finds the points of a picture that terrain hides from the Sun, exactly. The surface is closed, so a ray that leaves it towards the
/// Sun can meet it again only through a facet that faces away from the Sun: only these are looked at, and no point can hide itself.
/// One object serves frame after frame, one at a time, and keeps its memory.
/// </summary>
internal sealed class ShadowPass
{
    /// <summary>Every so many rows of the picture are read first, to lay out light space.</summary>
    private const int ScoutSpacing = 16;

    /// <summary>The sort keeps a count of every bin for each part that it does at the same time.</summary>
    private const int MostParts = 8;

    private readonly SurfaceModel _surface;
    private readonly BlockTree _tree;
    private readonly double _greatestRadius;
    private readonly double _solidRadius;
    private readonly ReceiverRows _receivers = new();
    private readonly ReceiverGrid _grid = new();
    private readonly List<CellBlock> _groups = [];
    private readonly List<CasterScan> _scans = [];
    private LightBox[] _boxes = [];

    /// <summary>Takes the model.</summary>
    /// <param name="surface">The model.</param>
    /// <param name="leastRadius">m: no vertex is lower.</param>
    /// <param name="greatestRadius">m: no vertex is higher.</param>
    public ShadowPass(SurfaceModel surface, double leastRadius, double greatestRadius)
    {
        _surface = surface;
        _tree = new BlockTree(surface, leastRadius, greatestRadius);
        _greatestRadius = greatestRadius + Tolerances.VertexLattice;
        _solidRadius = (leastRadius * MeshBounds.SagittaFactor(surface.Grid.PixelsPerDegree)) - Tolerances.VertexLattice;
    }

    /// <summary>What the last frame took.</summary>
    public ShadowStatistics Statistics { get; private set; }

    /// <summary>Marks the receivers that are in shadow.</summary>
    /// <param name="receivers">Points that may be lit.</param>
    /// <param name="sunMoonMe">m, MOON_ME.</param>
    /// <param name="hidden">Of each pixel, row by row: becomes 1 if terrain hides the Sun, else 0; other pixels become 0.</param>
    /// <param name="threads">How many may work, at least 1.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Run(IReceiverRows receivers, Vector3D sunMoonMe, byte[] hidden, int threads, CancellationToken cancellation)
    {
        if (!(sunMoonMe.Length > _greatestRadius))
        {
            throw new BadInputException($"The Sun is at {sunMoonMe} m, inside the Moon; give a position outside it.");
        }

        int rows = receivers.Rows;
        int width = receivers.Width;
        int parts = Math.Min(threads, MostParts);
        Array.Clear(hidden, 0, rows * width);
        Prepare(rows, width, threads);
        LightFrame frame = Scout(receivers, sunMoonMe, threads, parts, cancellation);
        LightBox box = SortReceivers(receivers, frame, hidden, threads, parts, cancellation);
        if (box.IsEmpty)
        {
            Statistics = default;
            return;
        }

        int blocks = CastShadows(frame, box, hidden, threads, cancellation);
        Statistics = new ShadowStatistics(
            _grid.Length, _groups.Count, blocks, _scans.Sum(scan => scan.Casters), _scans.Sum(scan => scan.Tries));
    }

    private void Prepare(int rows, int width, int threads)
    {
        _receivers.Prepare(rows, width);
        _grid.Prepare(_receivers.Start(rows));
        if (_boxes.Length < rows)
        {
            _boxes = new LightBox[rows];
        }

        while (_scans.Count < threads)
        {
            _scans.Add(new CasterScan(_surface));
        }
    }

    /// <summary>Lays out light space by a part of the rows; a bad choice costs time only.</summary>
    private LightFrame Scout(IReceiverRows receivers, Vector3D sunMoonMe, int threads, int parts, CancellationToken cancellation)
    {
        int scouts = (receivers.Rows + ScoutSpacing - 1) / ScoutSpacing;
        WorkerTeam.Run(threads, scouts, (_, scout) => _receivers.Read(receivers, scout * ScoutSpacing), cancellation);
        Vector3D sum = default;
        int count = 0;
        for (int row = 0; row < receivers.Rows; row += ScoutSpacing)
        {
            sum += _receivers.Sum(row);
            count += _receivers.Count(row);
        }

        LightFrame frame = new(sunMoonMe, sum);
        LightBox box = LightBox.Empty;
        for (int row = 0; row < receivers.Rows; row += ScoutSpacing)
        {
            _receivers.ToLight(frame, row);
            box = LightBox.Union(box, _receivers.BoxOf(row));
        }

        _grid.Lay(box.IsEmpty ? default : box, count * ScoutSpacing, parts);
        return frame;
    }

    /// <summary>Reads the other rows and sorts all receivers into the grid.</summary>
    private LightBox SortReceivers(
        IReceiverRows receivers, LightFrame frame, byte[] hidden, int threads, int parts, CancellationToken cancellation)
    {
        // In light space a ray keeps its distance from the axis; in space it passes the centre a little nearer.
        double ratio = _solidRadius / frame.SunDistance;
        double nightLimit = _solidRadius * _solidRadius / ((1.0 - ratio) * (1.0 + ratio));
        int rows = receivers.Rows;
        int width = receivers.Width;
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < rows; row = NextRow(row, parts))
            {
                cancellation.ThrowIfCancellationRequested();
                if (row % ScoutSpacing != 0)
                {
                    _receivers.Read(receivers, row);
                    _receivers.ToLight(frame, row);
                }

                _boxes[row] = _grid.Count(_receivers, row, part, nightLimit, hidden.AsSpan(row * width, width));
            }
        }, cancellation);
        _grid.Place();
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < rows; row = NextRow(row, parts))
            {
                _grid.Sort(_receivers, row, part, row * width);
            }
        }, cancellation);
        WorkerTeam.Run(threads, _grid.Size, (_, row) => _grid.FindDepths(row), cancellation);
        _grid.Finish();
        LightBox box = LightBox.Empty;
        for (int row = 0; row < rows; row++)
        {
            box = LightBox.Union(box, _boxes[row]);
        }

        return box;
    }

    private static int NextRow(int row, int parts) => row + parts;

    private int CastShadows(LightFrame frame, LightBox box, byte[] hidden, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(frame, _grid, box, _greatestRadius);
        _groups.Clear();
        _tree.FindGroups(bounds, _groups);
        foreach (CasterScan scan in _scans)
        {
            scan.Start(_grid, box, hidden);
        }

        int blocks = 0;
        WorkerTeam.Run(threads, _groups.Count, (worker, group) =>
        {
            Span<CellBlock> found = stackalloc CellBlock[BlockTree.GroupBlocks];
            int count = _tree.FindBlocks(_groups[group], bounds, found);
            Interlocked.Add(ref blocks, count);
            foreach (CellBlock block in found[..count])
            {
                _scans[worker].Add(block, frame);
            }
        }, cancellation);
        return blocks;
    }
}
