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

    private readonly SurfaceModel _surface;
    private readonly BlockTree _tree;
    private readonly double _greatestRadius;
    private readonly double _solidRadius;
    private readonly ReceiverStore _receivers = new();
    private readonly ReceiverMap _map = new();
    private readonly CasterStore _casters = new();
    private readonly CasterGrid _grid;
    private readonly List<CellBlock> _groups = [];
    private readonly List<CasterRun> _runs = [];
    private readonly List<CasterScan> _scans = [];
    private LightBox[] _boxes = [];
    private int[] _counts = [];

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
        _grid = new CasterGrid(_casters);
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
        Array.Clear(hidden, 0, rows * width);
        Prepare(rows, width, threads);
        LightFrame frame = Scout(receivers, sunMoonMe, threads, cancellation);
        WorkerTeam.Run(threads, rows, (_, row) =>
        {
            if (row % ScoutSpacing != 0)
            {
                _receivers.Read(receivers, row);
                _receivers.ToLight(frame, row);
            }

            DropNight(frame, row, hidden.AsSpan(row * width, width));
            ReceiverRow points = _receivers[row];
            _counts[row] = points.Count;
            _boxes[row] = points.Box();
            _map.Add(points.U, points.V, points.W);
        }, cancellation);
        _map.Finish();
        LightBox box = LightBox.Empty;
        int count = 0;
        for (int row = 0; row < rows; row++)
        {
            box = LightBox.Union(box, _boxes[row]);
            count += _counts[row];
        }

        if (box.IsEmpty)
        {
            Statistics = default;
            return;
        }

        int blocks = FindCasters(frame, box, threads, cancellation);
        int kept = _scans.Sum(scan => scan.Kept);
        int size = (int)Math.Clamp(Math.Sqrt(Math.Min(0.25 * count, 4.0 * kept)), 16.0, 2048.0);
        _grid.Build(_runs, box, size, threads, cancellation);
        WorkerTeam.Run(threads, rows, (_, row) => Test(row, hidden.AsSpan(row * width, width)), cancellation);
        Statistics = new ShadowStatistics(count, _groups.Count, blocks, kept, size * size, _grid.Entries);
    }

    private void Prepare(int rows, int width, int threads)
    {
        _receivers.Prepare(rows, width);
        if (_boxes.Length < rows)
        {
            _boxes = new LightBox[rows];
            _counts = new int[rows];
        }

        while (_scans.Count < threads)
        {
            _scans.Add(new CasterScan(_surface, _casters));
        }
    }

    /// <summary>Lays out light space by a part of the rows; a bad choice costs time only.</summary>
    private LightFrame Scout(IReceiverRows receivers, Vector3D sunMoonMe, int threads, CancellationToken cancellation)
    {
        int rows = receivers.Rows;
        int scouts = (rows + ScoutSpacing - 1) / ScoutSpacing;
        Vector3D[] sums = new Vector3D[scouts];
        WorkerTeam.Run(threads, scouts, (_, scout) =>
        {
            _receivers.Read(receivers, scout * ScoutSpacing);
            sums[scout] = _receivers.Sum(scout * ScoutSpacing);
        }, cancellation);
        Vector3D sum = default;
        foreach (Vector3D part in sums)
        {
            sum += part;
        }

        LightFrame frame = new(sunMoonMe, sum);
        LightBox box = LightBox.Empty;
        for (int scout = 0; scout < scouts; scout++)
        {
            _receivers.ToLight(frame, scout * ScoutSpacing);
            box = LightBox.Union(box, _receivers[scout * ScoutSpacing].Box());
        }

        _map.Clear(box.IsEmpty ? default : box);
        return frame;
    }

    /// <summary>Hides the receivers whose ray to the Sun passes below the lowest terrain, and takes them out.</summary>
    private void DropNight(LightFrame frame, int row, Span<byte> hidden)
    {
        // In light space a ray keeps its distance from the axis; in space it passes the centre a little nearer.
        double ratio = _solidRadius / frame.SunDistance;
        double limit = _solidRadius * _solidRadius / ((1.0 - ratio) * (1.0 + ratio));
        ReceiverRow points = _receivers[row];
        int kept = 0;
        for (int i = 0; i < points.Count; i++)
        {
            double u = points.U[i];
            double v = points.V[i];
            double w = points.W[i];
            if (w > 0.0 && (u * u) + (v * v) < limit)
            {
                hidden[points.Columns[i]] = 1;
                continue;
            }

            points.U[kept] = u;
            points.V[kept] = v;
            points.W[kept] = w;
            points.Columns[kept++] = points.Columns[i];
        }

        _receivers.Truncate(row, kept);
    }

    private int FindCasters(LightFrame frame, LightBox box, int threads, CancellationToken cancellation)
    {
        CasterBounds bounds = new(frame, _map, box, _greatestRadius);
        _groups.Clear();
        _tree.FindGroups(bounds, _groups);
        _casters.Clear();
        foreach (CasterScan scan in _scans)
        {
            scan.Start(_map, box);
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
        _runs.Clear();
        foreach (CasterScan scan in _scans)
        {
            _runs.AddRange(scan.Runs);
        }

        return blocks;
    }

    private void Test(int row, Span<byte> hidden)
    {
        ReceiverRow points = _receivers[row];
        for (int i = 0; i < points.Count; i++)
        {
            if (_grid.IsHidden(points.U[i], points.V[i], points.W[i]))
            {
                hidden[points.Columns[i]] = 1;
            }
        }
    }
}
