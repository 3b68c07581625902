using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Marks which points of the Sun's disc the facets of a block of terrain hide from the receivers. Each thread needs its own object;
/// several objects may work on one grid, because the result does not depend on their order.
/// </summary>
internal sealed class PenumbraScan
{
    private readonly SurfaceModel _surface;
    private readonly BlockVertices _vertices = new();
    private readonly CellStrip _strip;

    public PenumbraScan(SurfaceModel surface)
    {
        _surface = surface;
        _strip = new CellStrip(_vertices);
    }

    /// <summary>Marks the points of the disc that a block hides from the receivers.</summary>
    /// <param name="slope">Radius of the disc over its distance.</param>
    /// <param name="hidden">For each pixel, row by row, the mask of the disc's points that terrain hides; bits are added.</param>
    public void Cast(CellBlock block, SortedReceivers grid, DiscRays rays, double slope, ulong[] hidden)
    {
        _vertices.Load(_surface, block, default);
        int length = _vertices.Lines * BlockVertices.Stride;
        grid.Frame.FromBodyFixed(_vertices.X.AsSpan(0, length), _vertices.Y.AsSpan(0, length), _vertices.Z.AsSpan(0, length));
        double deepest = grid.Bins.Max();
        LightBox reach = grid.Box.Widened(slope * Math.Max(0.0, deepest - _vertices.MinZ()));
        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            for (int sample = 0; sample + 1 < _vertices.Samples; sample += CellStrip.Cells)
            {
                if (!_strip.TrySet(line, sample, in reach, slope) || !(_strip.MinDepth < deepest))
                {
                    continue;
                }

                // The deeper a receiver is behind the facets, the farther to their side they can hide a part of the disc from it.
                double depth = grid.Bins.Max(grid.Bins.BinsOf(_strip.Box.Widened(slope * (deepest - _strip.MinDepth))));
                if (_strip.MinDepth < depth)
                {
                    CastStrip(grid, _strip.Box.Widened(slope * (depth - _strip.MinDepth)), rays, slope, hidden);
                }
            }
        }
    }

    private void CastStrip(SortedReceivers grid, LightBox reach, DiscRays rays, double slope, ulong[] hidden)
    {
        GridRange bins = grid.Bins.BinsOf(in reach);
        ReadOnlySpan<double> us = grid.U;
        ReadOnlySpan<double> vs = grid.V;
        ReadOnlySpan<double> ws = grid.W;
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            (int first, int end) = grid.Run(row, bins.FirstColumn, bins.LastColumn);
            for (int i = first; i < end; i += Vector512<double>.Count)
            {
                Vector512<double> u = ArrayLanes.Load(us, i);
                Vector512<double> v = ArrayLanes.Load(vs, i);
                Vector512<double> behind = ArrayLanes.Load(ws, i) - Vector512.Create(_strip.MinDepth);
                Vector512<double> margin = Vector512.Create(slope) * behind;
                uint isNear = SortedReceivers.Meant(i, end) & (uint)(Vector512.GreaterThan(behind, Vector512<double>.Zero)
                    & Vector512.GreaterThanOrEqual(u + margin, Vector512.Create(_strip.Box.MinU))
                    & Vector512.LessThanOrEqual(u - margin, Vector512.Create(_strip.Box.MaxU))
                    & Vector512.GreaterThanOrEqual(v + margin, Vector512.Create(_strip.Box.MinV))
                    & Vector512.LessThanOrEqual(v - margin, Vector512.Create(_strip.Box.MaxV))).ExtractMostSignificantBits();
                for (; isNear != 0; isNear &= isNear - 1)
                {
                    Hide(grid, i + BitOperations.TrailingZeroCount(isNear), rays, slope, hidden);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    private void Hide(SortedReceivers grid, int receiver, DiscRays rays, double slope, ulong[] hidden)
    {
        Vector3D point = new(grid.U[receiver], grid.V[receiver], grid.W[receiver]);
        if (double.IsNegativeInfinity(point.Z))
        {
            return; // another thread has just found the whole disc hidden
        }

        ref ulong known = ref hidden[grid.Pixels[receiver]];
        ulong before = Volatile.Read(ref known);
        uint near = _strip.CellsNear(point, slope, rays.MinA(~before));
        if (near == 0)
        {
            return;
        }

        ulong found = before | rays.HiddenBy(
            _vertices, _strip.NorthWest, near & _strip.SouthWestAway, near & _strip.NorthEastAway, point, ~before);
        if (found != before && (Interlocked.Or(ref known, found) | found) == SunDisc.All)
        {
            grid.TakeOut(receiver);
        }
    }
}
