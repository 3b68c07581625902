using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Goes through blocks of the terrain and lets each facet that faces away from the Sun hide the receivers behind it. One object for one
/// thread; several may work on one grid, for the result does not depend on their order.
/// </summary>
internal sealed class CasterScan(SurfaceModel surface)
{
    private readonly BlockVertices _vertices = new();
    private ReceiverGrid _grid = null!;
    private LightBox _receivers;
    private byte[] _hidden = [];

    /// <summary>Facets since <see cref="Start"/> that have a receiver behind their box.</summary>
    public int Casters { get; private set; }

    /// <summary>Receivers since <see cref="Start"/> that were tried, in vectors of eight.</summary>
    public long Tries { get; private set; }

    /// <summary>Begins a frame.</summary>
    /// <param name="grid">The receivers.</param>
    /// <param name="receivers">They all are in it.</param>
    /// <param name="hidden">Of each pixel; becomes 1 if terrain hides the Sun.</param>
    public void Start(ReceiverGrid grid, LightBox receivers, byte[] hidden)
    {
        _grid = grid;
        _receivers = receivers;
        _hidden = hidden;
        Casters = 0;
        Tries = 0;
    }

    /// <summary>Goes through a block.</summary>
    public void Add(CellBlock block, LightFrame frame)
    {
        _vertices.Load(surface, block, default);
        int length = _vertices.Lines * BlockVertices.Stride;
        frame.FromMoonMe(_vertices.X.AsSpan(0, length), _vertices.Y.AsSpan(0, length), _vertices.Z.AsSpan(0, length));
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            AddLine(line);
        }
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
                Cast(at, at + BlockVertices.Stride, at + BlockVertices.Stride + 1);
            }

            for (; awayNorthEast != 0; awayNorthEast &= awayNorthEast - 1)
            {
                int at = (int)northWest + BitOperations.TrailingZeroCount(awayNorthEast);
                Cast(at, at + BlockVertices.Stride + 1, at + 1);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Min(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MinNative(Vector512.MinNative(a, b), Vector512.MinNative(c, d));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Max(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MaxNative(Vector512.MaxNative(a, b), Vector512.MaxNative(c, d));

    private void Cast(int a, int b, int c)
    {
        Facet facet = new(
            _vertices.X[a], _vertices.Y[a], _vertices.Z[a],
            _vertices.X[b], _vertices.Y[b], _vertices.Z[b],
            _vertices.X[c], _vertices.Y[c], _vertices.Z[c]);
        LightAxis axisU = _grid.AxisU;
        LightAxis axisV = _grid.AxisV;
        int firstColumn = axisU.BinOf(Math.Min(facet.Ua, Math.Min(facet.Ub, facet.Uc)));
        int lastColumn = axisU.BinOf(Math.Max(facet.Ua, Math.Max(facet.Ub, facet.Uc)));
        int firstRow = axisV.BinOf(Math.Min(facet.Va, Math.Min(facet.Vb, facet.Vc)));
        int lastRow = axisV.BinOf(Math.Max(facet.Va, Math.Max(facet.Vb, facet.Vc)));
        if (!(Math.Min(facet.Wa, Math.Min(facet.Wb, facet.Wc)) < _grid.GreatestDepth(firstColumn, lastColumn, firstRow, lastRow)))
        {
            return;
        }

        Casters++;
        for (int row = firstRow; row <= lastRow; row++)
        {
            (int first, int end) = _grid.Run(row, firstColumn, lastColumn);
            if (end > first)
            {
                Hide(in facet, first, end);
            }
        }
    }

    private void Hide(in Facet facet, int first, int end)
    {
        ref double us = ref MemoryMarshal.GetArrayDataReference(_grid.U);
        ref double vs = ref MemoryMarshal.GetArrayDataReference(_grid.V);
        ref double ws = ref MemoryMarshal.GetArrayDataReference(_grid.W);
        Tries += (end - first + 7) / 8;
        for (int i = first; i < end; i += Vector512<double>.Count)
        {
            Vector512<double> u = Vector512.LoadUnsafe(ref us, (nuint)i);
            Vector512<double> v = Vector512.LoadUnsafe(ref vs, (nuint)i);
            Vector512<double> ua = Vector512.Create(facet.Ua) - u;
            Vector512<double> va = Vector512.Create(facet.Va) - v;
            Vector512<double> ub = Vector512.Create(facet.Ub) - u;
            Vector512<double> vb = Vector512.Create(facet.Vb) - v;
            Vector512<double> uc = Vector512.Create(facet.Uc) - u;
            Vector512<double> vc = Vector512.Create(facet.Vc) - v;
            Vector512<double> weightC = (ua * vb) - (ub * va);
            Vector512<double> weightA = (ub * vc) - (uc * vb);
            Vector512<double> weightB = (uc * va) - (ua * vc);
            Vector512<double> isInside = Vector512.GreaterThanOrEqual(
                Vector512.MinNative(weightA, Vector512.MinNative(weightB, weightC)), Vector512<double>.Zero);
            if (isInside == Vector512<double>.Zero)
            {
                continue;
            }

            Vector512<double> w = Vector512.LoadUnsafe(ref ws, (nuint)i);
            Vector512<double> deeper = (weightA * (Vector512.Create(facet.Wa) - w))
                + (weightB * (Vector512.Create(facet.Wb) - w))
                + (weightC * (Vector512.Create(facet.Wc) - w));
            uint isHidden = (uint)(isInside & Vector512.LessThan(deeper, Vector512<double>.Zero)).ExtractMostSignificantBits();
            isHidden &= (1u << Math.Min(end - i, Vector512<double>.Count)) - 1;
            for (; isHidden != 0; isHidden &= isHidden - 1)
            {
                _hidden[_grid.Pixels[i + BitOperations.TrailingZeroCount(isHidden)]] = 1;
            }
        }
    }

    private readonly record struct Facet(
        double Ua, double Va, double Wa, double Ub, double Vb, double Wb, double Uc, double Vc, double Wc);
}
