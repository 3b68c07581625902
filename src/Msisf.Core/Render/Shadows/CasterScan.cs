using System.Numerics;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Marks the receivers that the facets of a block of terrain hide from the Sun. Each thread needs its own object; several objects may
/// work on one grid, because the result does not depend on their order.
/// </summary>
internal sealed class CasterScan
{
    /// <summary>
    /// Number of bins that a strip must cover for its facets to be tested one by one, each against vectors of eight receivers. A strip that
    /// covers fewer bins holds few receivers, so each receiver is tested against the eight cells of the strip at once.
    /// </summary>
    private const int ManyBins = 64;

    private readonly SurfaceModel _surface;
    private readonly BlockVertices _vertices = new();
    private readonly CellStrip _strip;

    public CasterScan(SurfaceModel surface)
    {
        _surface = surface;
        _strip = new CellStrip(_vertices);
    }

    /// <summary>Number of strips since <see cref="Start"/> that may have a receiver behind them.</summary>
    public int Strips { get; private set; }

    /// <summary>Number of vectors of eight receivers that were tested since <see cref="Start"/>.</summary>
    public long Tries { get; private set; }

    /// <summary>Sets <see cref="Strips"/> and <see cref="Tries"/> to 0.</summary>
    public void Start()
    {
        Strips = 0;
        Tries = 0;
    }

    /// <summary>Marks the bins in which a block may hide receivers, so that they are sorted.</summary>
    public void WantBins(CellBlock block, PlacedReceivers receivers)
    {
        Load(block, receivers.Frame);
        LightBox box = receivers.Box;
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            for (int sample = 0; sample + 1 < _vertices.Samples; sample += CellStrip.Cells)
            {
                if (TrySetStrip(line, sample, receivers.Bins, in box, out GridRange bins))
                {
                    receivers.Want(bins);
                }
            }
        }
    }

    /// <summary>Adds the facets of a block that may hide a receiver from the Sun.</summary>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <param name="casters">Receives the facets.</param>
    public void Find(CellBlock block, IReceiverBounds receivers, double slope, CasterDepths casters)
    {
        Load(block, receivers.Frame);
        double deepest = receivers.MaxDepth;
        LightBox box = receivers.Box.Widened(slope * Math.Max(0.0, deepest - _vertices.MinZ()));
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            for (int sample = 0; sample + 1 < _vertices.Samples; sample += CellStrip.Cells)
            {
                if (!_strip.TrySet(line, sample, in box, slope)
                    || !(_strip.MinDepth < receivers.MaxDepthIn(_strip.Box.Widened(slope * Math.Max(0.0, deepest - _strip.MinDepth)))))
                {
                    continue;
                }

                for (uint away = _strip.SouthWestAway; away != 0; away &= away - 1)
                {
                    casters.Add(_strip.SouthWestFacet(BitOperations.TrailingZeroCount(away)));
                }

                for (uint away = _strip.NorthEastAway; away != 0; away &= away - 1)
                {
                    casters.Add(_strip.NorthEastFacet(BitOperations.TrailingZeroCount(away)));
                }
            }
        }
    }

    /// <summary>Marks the receivers that a block hides from the Sun.</summary>
    /// <param name="hidden">One value for each pixel, row by row; set to 1 where terrain hides the Sun.</param>
    public void Cast(CellBlock block, SortedReceivers grid, byte[] hidden)
    {
        Load(block, grid.Frame);
        LightBox box = grid.Box;
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            for (int sample = 0; sample + 1 < _vertices.Samples; sample += CellStrip.Cells)
            {
                if (!TrySetStrip(line, sample, grid.Bins, in box, out GridRange bins))
                {
                    continue;
                }

                Strips++;
                if (bins.Count < ManyBins)
                {
                    CastStrip(grid, bins, hidden);
                }
                else
                {
                    CastFacets(grid, hidden);
                }
            }
        }
    }

    private void Load(CellBlock block, LightFrame frame)
    {
        _vertices.Load(_surface, block, default);
        int length = _vertices.Lines * BlockVertices.Stride;
        frame.FromBodyFixed(_vertices.X.AsSpan(0, length), _vertices.Y.AsSpan(0, length), _vertices.Z.AsSpan(0, length));
    }

    /// <summary>Sets the strip to eight cells and tells whether a receiver may be behind them.</summary>
    private bool TrySetStrip(int line, int sample, DepthGrid receivers, in LightBox box, out GridRange bins)
    {
        bins = default;
        if (!_strip.TrySet(line, sample, in box, slope: 0.0))
        {
            return false;
        }

        bins = receivers.BinsOf(in _strip.Box);
        return _strip.MinDepth < receivers.Max(bins);
    }

    private void CastStrip(SortedReceivers grid, GridRange bins, byte[] hidden)
    {
        ReadOnlySpan<double> us = grid.U;
        ReadOnlySpan<double> vs = grid.V;
        ReadOnlySpan<double> ws = grid.W;
        Vector512<double> minU = Vector512.Create(_strip.Box.MinU);
        Vector512<double> maxU = Vector512.Create(_strip.Box.MaxU);
        Vector512<double> minV = Vector512.Create(_strip.Box.MinV);
        Vector512<double> maxV = Vector512.Create(_strip.Box.MaxV);
        Vector512<double> minDepth = Vector512.Create(_strip.MinDepth);
        LightSlab? slab = null;
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            (int first, int end) = grid.Run(row, bins.FirstColumn, bins.LastColumn);
            for (int i = first; i < end; i += Vector512<double>.Count)
            {
                Tries++;
                Vector512<double> u = ArrayLanes.Load(us, i);
                Vector512<double> v = ArrayLanes.Load(vs, i);
                Vector512<double> w = ArrayLanes.Load(ws, i);
                uint isInBox = SortedReceivers.Meant(i, end) & (uint)(Vector512.GreaterThan(w, minDepth)
                    & Vector512.GreaterThanOrEqual(u, minU)
                    & Vector512.LessThanOrEqual(u, maxU)
                    & Vector512.GreaterThanOrEqual(v, minV)
                    & Vector512.LessThanOrEqual(v, maxV)).ExtractMostSignificantBits();
                if (isInBox == 0)
                {
                    continue;
                }

                slab ??= _strip.FindSlab();
                for (isInBox &= slab.Value.Holds(u, v); isInBox != 0; isInBox &= isInBox - 1)
                {
                    int receiver = i + BitOperations.TrailingZeroCount(isInBox);
                    if (_strip.IsInFrontOf(grid.U[receiver], grid.V[receiver], grid.W[receiver]))
                    {
                        grid.TakeOut(receiver);
                        hidden[grid.Pixels[receiver]] = 1;
                    }
                }
            }
        }
    }

    private void CastFacets(SortedReceivers grid, byte[] hidden)
    {
        for (uint away = _strip.SouthWestAway; away != 0; away &= away - 1)
        {
            Tries += FacetCaster.Cast(_strip.SouthWestFacet(BitOperations.TrailingZeroCount(away)), grid, hidden);
        }

        for (uint away = _strip.NorthEastAway; away != 0; away &= away - 1)
        {
            Tries += FacetCaster.Cast(_strip.NorthEastFacet(BitOperations.TrailingZeroCount(away)), grid, hidden);
        }
    }
}
