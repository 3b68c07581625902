using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Goes through blocks of the terrain and keeps the facets that may cast a shadow on a receiver: they face away from the Sun, and a
/// receiver may lie behind them. One object for one thread.
/// </summary>
internal sealed class CasterScan(SurfaceModel surface, CasterStore store)
{
    private readonly BlockVertices _vertices = new();
    private readonly List<CasterRun> _runs = [];
    private ReceiverMap? _map;
    private LightBox _receivers;
    private int _next;
    private int _end;
    private int _runStart;
    private double _leastV;
    private double _greatestV;

    /// <summary>What was kept since <see cref="Start"/>.</summary>
    public List<CasterRun> Runs => _runs;

    /// <summary>Facets kept since <see cref="Start"/>.</summary>
    public int Kept { get; private set; }

    /// <summary>Begins a frame.</summary>
    /// <param name="map">The receivers.</param>
    /// <param name="receivers">They all are in it.</param>
    public void Start(ReceiverMap map, LightBox receivers)
    {
        _map = map;
        _receivers = receivers;
        _runs.Clear();
        _next = 0;
        _end = 0;
        Kept = 0;
    }

    /// <summary>Adds what is to be kept of a block.</summary>
    public void Add(CellBlock block, LightFrame frame)
    {
        _vertices.Load(surface, block, default);
        int length = _vertices.Lines * BlockVertices.Stride;
        frame.FromMoonMe(_vertices.X.AsSpan(0, length), _vertices.Y.AsSpan(0, length), _vertices.Z.AsSpan(0, length));
        BeginRun();
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            AddLine(line);
        }

        EndRun();
    }

    private void AddLine(int line)
    {
        ref double u = ref MemoryMarshal.GetArrayDataReference(_vertices.X);
        ref double v = ref MemoryMarshal.GetArrayDataReference(_vertices.Y);
        Vector512<double> leastU = Vector512.Create(_receivers.LeastU);
        Vector512<double> greatestU = Vector512.Create(_receivers.GreatestU);
        Vector512<double> leastV = Vector512.Create(_receivers.LeastV);
        Vector512<double> greatestV = Vector512.Create(_receivers.GreatestV);
        int cells = _vertices.Samples - 1;
        for (int sample = 0; sample < cells; sample += Vector512<double>.Count)
        {
            nuint northWest = (nuint)((line * BlockVertices.Stride) + sample);
            nuint southWest = northWest + BlockVertices.Stride;
            Vector512<double> uNorthWest = Vector512.LoadUnsafe(ref u, northWest);
            Vector512<double> vNorthWest = Vector512.LoadUnsafe(ref v, northWest);
            Vector512<double> uNorthEast = Vector512.LoadUnsafe(ref u, northWest + 1);
            Vector512<double> vNorthEast = Vector512.LoadUnsafe(ref v, northWest + 1);
            Vector512<double> uSouthWest = Vector512.LoadUnsafe(ref u, southWest);
            Vector512<double> vSouthWest = Vector512.LoadUnsafe(ref v, southWest);
            Vector512<double> uSouthEast = Vector512.LoadUnsafe(ref u, southWest + 1);
            Vector512<double> vSouthEast = Vector512.LoadUnsafe(ref v, southWest + 1);
            Vector512<double> uDiagonal = uSouthEast - uNorthWest;
            Vector512<double> vDiagonal = vSouthEast - vNorthWest;
            Vector512<double> areaSouthWest = ((uSouthWest - uNorthWest) * vDiagonal) - ((vSouthWest - vNorthWest) * uDiagonal);
            Vector512<double> areaNorthEast = (uDiagonal * (vNorthEast - vNorthWest)) - (vDiagonal * (uNorthEast - uNorthWest));
            Vector512<double> inBox = Vector512.LessThanOrEqual(leastU, Max(uNorthWest, uNorthEast, uSouthWest, uSouthEast))
                & Vector512.GreaterThanOrEqual(greatestU, Min(uNorthWest, uNorthEast, uSouthWest, uSouthEast))
                & Vector512.LessThanOrEqual(leastV, Max(vNorthWest, vNorthEast, vSouthWest, vSouthEast))
                & Vector512.GreaterThanOrEqual(greatestV, Min(vNorthWest, vNorthEast, vSouthWest, vSouthEast));
            uint inBlock = (1u << Math.Min(cells - sample, Vector512<double>.Count)) - 1;
            uint awaySouthWest = (uint)(Vector512.GreaterThan(areaSouthWest, Vector512<double>.Zero) & inBox).ExtractMostSignificantBits() & inBlock;
            uint awayNorthEast = (uint)(Vector512.GreaterThan(areaNorthEast, Vector512<double>.Zero) & inBox).ExtractMostSignificantBits() & inBlock;
            for (; awaySouthWest != 0; awaySouthWest &= awaySouthWest - 1)
            {
                int at = (int)northWest + BitOperations.TrailingZeroCount(awaySouthWest);
                Keep(at, at + BlockVertices.Stride, at + BlockVertices.Stride + 1);
            }

            for (; awayNorthEast != 0; awayNorthEast &= awayNorthEast - 1)
            {
                int at = (int)northWest + BitOperations.TrailingZeroCount(awayNorthEast);
                Keep(at, at + BlockVertices.Stride + 1, at + 1);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Min(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MinNative(Vector512.MinNative(a, b), Vector512.MinNative(c, d));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Max(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MaxNative(Vector512.MaxNative(a, b), Vector512.MaxNative(c, d));

    private void Keep(int a, int b, int c)
    {
        double[] u = _vertices.X;
        double[] v = _vertices.Y;
        double[] w = _vertices.Z;
        LightBox box = new(
            Math.Min(u[a], Math.Min(u[b], u[c])),
            Math.Max(u[a], Math.Max(u[b], u[c])),
            Math.Min(v[a], Math.Min(v[b], v[c])),
            Math.Max(v[a], Math.Max(v[b], v[c])));
        if (!(Math.Min(w[a], Math.Min(w[b], w[c])) < _map!.GreatestDepth(box)))
        {
            return;
        }

        if (_next == _end)
        {
            EndRun();
            _next = store.TakeChunk();
            _end = _next + CasterStore.ChunkSize;
            BeginRun();
        }

        ref double facet = ref store[_next++];
        facet = u[a];
        Unsafe.Add(ref facet, 1) = u[b];
        Unsafe.Add(ref facet, 2) = u[c];
        Unsafe.Add(ref facet, 4) = v[a];
        Unsafe.Add(ref facet, 5) = v[b];
        Unsafe.Add(ref facet, 6) = v[c];
        Unsafe.Add(ref facet, 8) = w[c];
        Unsafe.Add(ref facet, 9) = w[a];
        Unsafe.Add(ref facet, 10) = w[b];
        _leastV = Math.Min(_leastV, box.LeastV);
        _greatestV = Math.Max(_greatestV, box.GreatestV);
    }

    private void BeginRun()
    {
        _runStart = _next;
        _leastV = double.PositiveInfinity;
        _greatestV = double.NegativeInfinity;
    }

    private void EndRun()
    {
        if (_next > _runStart)
        {
            _runs.Add(new CasterRun(_runStart, _next - _runStart, _leastV, _greatestV));
            Kept += _next - _runStart;
        }
    }
}
