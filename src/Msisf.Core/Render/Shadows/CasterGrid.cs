using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The facets that may cast a shadow, in a grid of bins across the Sun's rays; each bin lists the facets that may touch it.</summary>
internal sealed class CasterGrid(CasterStore store)
{
    /// <summary>Rows of bins are filled in this many parts for each thread, so that crowded rows don't keep one thread busy alone.</summary>
    private const int PartsPerThread = 4;

    private LightAxis _u;
    private LightAxis _v;
    private int _size;
    private int[] _ends = [];
    private int[] _facets = [];
    private int[] _partEntries = [];

    /// <summary>Facets in the lists of all bins together.</summary>
    public int Entries { get; private set; }

    /// <summary>Bins to an edge.</summary>
    public int Size => _size;

    /// <summary>Sorts facets into bins.</summary>
    /// <param name="runs">The facets.</param>
    /// <param name="receivers">The grid lies over it.</param>
    /// <param name="size">Bins to an edge.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    public void Build(List<CasterRun> runs, LightBox receivers, int size, int threads, CancellationToken cancellation)
    {
        _size = size;
        _u = new LightAxis(receivers.LeastU, receivers.GreatestU, size);
        _v = new LightAxis(receivers.LeastV, receivers.GreatestV, size);
        if (_ends.Length < (size * size) + 1)
        {
            _ends = new int[(size * size) + 1];
        }

        int parts = threads == 1 ? 1 : Math.Min(size, PartsPerThread * threads);
        if (_partEntries.Length < parts)
        {
            _partEntries = new int[parts];
        }

        WorkerTeam.Run(threads, parts, (_, part) => Count(runs, part, parts), cancellation);
        Entries = 0;
        for (int part = 0; part < parts; part++)
        {
            (_partEntries[part], Entries) = (Entries, Entries + _partEntries[part]);
        }

        if (_facets.Length < Entries)
        {
            _facets = new int[Math.Max(Entries, 2 * _facets.Length)];
        }

        WorkerTeam.Run(threads, parts, (_, part) => Fill(runs, part, parts), cancellation);
    }

    /// <summary>Whether a facet lies between a point and the Sun.</summary>
    public bool IsHidden(double u, double v, double w)
    {
        int bin = (_v.BinOf(v) * _size) + _u.BinOf(u);
        int end = _ends[bin + 1];
        for (int entry = _ends[bin]; entry < end; entry++)
        {
            if (IsBehind(u, v, w, ref store[_facets[entry]]))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// The edge functions e are exactly antisymmetric in an edge's ends, so of two facets that share it at least one holds each point
    /// of it. The facet's depth at the point is the mean of its corners' with the weights e, and only its sign against the point's is
    /// needed: nothing is divided.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsBehind(double u, double v, double w, ref double facet)
    {
        Vector256<double> du = Vector256.LoadUnsafe(ref facet) - Vector256.Create(u);
        Vector256<double> dv = Vector256.LoadUnsafe(ref facet, 4) - Vector256.Create(v);
        Vector256<long> next = Vector256.Create(1L, 2L, 0L, 3L);
        Vector256<double> edges = (du * Vector256.Shuffle(dv, next)) - (Vector256.Shuffle(du, next) * dv);
        if ((Vector256.GreaterThanOrEqual(edges, Vector256<double>.Zero).ExtractMostSignificantBits() & 7) != 7)
        {
            return false;
        }

        Vector256<double> deeper = edges * (Vector256.LoadUnsafe(ref facet, 8) - Vector256.Create(w));
        return deeper[0] + deeper[1] + deeper[2] < 0.0;
    }

    private void Count(List<CasterRun> runs, int part, int parts)
    {
        (int firstRow, int endRow) = RowsOf(part, parts);
        Span<int> counts = _ends.AsSpan((firstRow * _size) + 1, (endRow - firstRow) * _size);
        counts.Clear();
        int entries = 0;
        foreach (CasterRun run in runs)
        {
            if (_v.BinOf(run.GreatestV) < firstRow || _v.BinOf(run.LeastV) >= endRow)
            {
                continue;
            }

            for (int facet = run.First; facet < run.First + run.Count; facet++)
            {
                (int firstColumn, int lastColumn, int row, int lastRow) = BinsOf(facet, firstRow, endRow);
                for (; row <= lastRow; row++)
                {
                    for (int column = firstColumn; column <= lastColumn; column++)
                    {
                        counts[((row - firstRow) * _size) + column]++;
                        entries++;
                    }
                }
            }
        }

        _partEntries[part] = entries;
    }

    /// <summary>Turns the counts of a part into the starts of its lists, then fills these, which moves each start to its list's end.</summary>
    private void Fill(List<CasterRun> runs, int part, int parts)
    {
        (int firstRow, int endRow) = RowsOf(part, parts);
        Span<int> ends = _ends.AsSpan((firstRow * _size) + 1, (endRow - firstRow) * _size);
        int start = _partEntries[part];
        for (int bin = 0; bin < ends.Length; bin++)
        {
            (ends[bin], start) = (start, start + ends[bin]);
        }

        foreach (CasterRun run in runs)
        {
            if (_v.BinOf(run.GreatestV) < firstRow || _v.BinOf(run.LeastV) >= endRow)
            {
                continue;
            }

            for (int facet = run.First; facet < run.First + run.Count; facet++)
            {
                (int firstColumn, int lastColumn, int row, int lastRow) = BinsOf(facet, firstRow, endRow);
                for (; row <= lastRow; row++)
                {
                    for (int column = firstColumn; column <= lastColumn; column++)
                    {
                        _facets[ends[((row - firstRow) * _size) + column]++] = facet;
                    }
                }
            }
        }
    }

    private (int First, int End) RowsOf(int part, int parts) => (part * _size / parts, (part + 1) * _size / parts);

    private (int FirstColumn, int LastColumn, int FirstRow, int LastRow) BinsOf(int facet, int firstRow, int endRow)
    {
        ref double corners = ref store[facet];
        double ua = corners;
        double ub = Unsafe.Add(ref corners, 1);
        double uc = Unsafe.Add(ref corners, 2);
        double va = Unsafe.Add(ref corners, 4);
        double vb = Unsafe.Add(ref corners, 5);
        double vc = Unsafe.Add(ref corners, 6);
        return (
            _u.BinOf(Math.Min(ua, Math.Min(ub, uc))),
            _u.BinOf(Math.Max(ua, Math.Max(ub, uc))),
            Math.Max(firstRow, _v.BinOf(Math.Min(va, Math.Min(vb, vc)))),
            Math.Min(endRow - 1, _v.BinOf(Math.Max(va, Math.Max(vb, vc)))));
    }
}
