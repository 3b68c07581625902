using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Illumination;

/// <summary>The vertices of a patch of 8 x 8 cells as they are seen from a place, an array for each coordinate.</summary>
internal sealed class PatchPoints
{
    /// <summary>Cells along an edge of a patch.</summary>
    public const int Cells = 8;

    /// <summary>Elements from one line of vertices to the next: 9 in two vectors.</summary>
    private const int Stride = 2 * Cells;

    private readonly double[] _east = new double[(Cells + 1) * Stride];
    private readonly double[] _north = new double[(Cells + 1) * Stride];
    private readonly double[] _up = new double[(Cells + 1) * Stride];
    private readonly float[] _columns = new float[(Cells + 1) * Stride];
    private readonly float[] _tangents = new float[(Cells + 1) * Stride];

    /// <summary>Turns the vertices of a patch.</summary>
    /// <param name="vertices">Those of its block.</param>
    /// <param name="origin">To which they are relative, m, body-fixed.</param>
    /// <param name="top">Line of the patch in the block.</param>
    /// <param name="left">Its sample.</param>
    /// <param name="cells">Its cells.</param>
    /// <param name="frame">The place.</param>
    /// <param name="columns">Columns of a turn.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Place(BlockVertices vertices, Vector3D origin, int top, int left, CellRange cells, in LocalFrame frame, int columns)
    {
        Vector3D start = frame.ToLocal(origin - frame.PositionBodyFixed);
        for (int line = 0; line <= cells.Lines; line++)
        {
            nuint from = (nuint)(((top + line) * BlockVertices.Stride) + left);
            int to = line * Stride;
            Turn(vertices, from, start, frame, to);
            Turn(vertices, from + Cells, start, frame, to + Cells);

            // Relative to the place, so that floats have digits enough.
            Vector512<float> east = Vector512.Narrow(Vector512.LoadUnsafe(ref _east[to]), Vector512.LoadUnsafe(ref _east[to + Cells]));
            Vector512<float> north = Vector512.Narrow(Vector512.LoadUnsafe(ref _north[to]), Vector512.LoadUnsafe(ref _north[to + Cells]));
            Vector512<float> up = Vector512.Narrow(Vector512.LoadUnsafe(ref _up[to]), Vector512.LoadUnsafe(ref _up[to + Cells]));
            Vector512<float> across = Vector512.Sqrt((east * east) + (north * north));
            Vector512<float> tangent = up / Vector512.MaxNative(across, Vector512.Create(1e-9f));
            Vector512.MaxNative(tangent, Vector512.Create(HorizonPoint.Lowest)).StoreUnsafe(ref _tangents[to]);
            (AzimuthLanes.Turns(east, north) * Vector512.Create((float)columns)).StoreUnsafe(ref _columns[to]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Turn(BlockVertices vertices, nuint from, Vector3D start, in LocalFrame frame, int to)
    {
        Vector512<double> x = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.X), from);
        Vector512<double> y = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.Y), from);
        Vector512<double> z = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.Z), from);
        Along(frame.East, start.X, x, y, z).StoreUnsafe(ref _east[to]);
        Along(frame.North, start.Y, x, y, z).StoreUnsafe(ref _north[to]);
        Along(frame.Up, start.Z, x, y, z).StoreUnsafe(ref _up[to]);
    }

    /// <summary>Raises a horizon to the edges of the patch's facets.</summary>
    /// <param name="buffer">The horizon.</param>
    /// <param name="cells">The patch's cells.</param>
    /// <param name="part">Tells which cells the surface has.</param>
    public void RaiseAll(HorizonBuffer buffer, CellRange cells, GridPatch part)
    {
        bool isWhole = part.Kept is null || part.Kept.StateOf(
            (cells.FirstLine - part.Mesh.Cells.FirstLine) / CellBlock.Size,
            (cells.FirstSample - part.Mesh.Cells.FirstSample) / CellBlock.Size) == CellMask.BlockState.Whole;
        if (isWhole)
        {
            RaiseRidges(buffer, cells);
            return;
        }

        for (int cell = 0; cell < cells.Lines * cells.Samples; cell++)
        {
            (int line, int sample) = (cell / cells.Samples, cell % cells.Samples);
            int at = (line * Stride) + sample;
            if (MayRise(buffer, at, 1) && part.Has(cells.FirstLine + line, cells.FirstSample + sample))
            {
                buffer.Raise(this[at], this[at + 1]);
                buffer.Raise(this[at], this[at + Stride]);
                buffer.Raise(this[at], this[at + Stride + 1]);
                buffer.Raise(this[at + 1], this[at + Stride + 1]);
                buffer.Raise(this[at + Stride], this[at + Stride + 1]);
            }
        }
    }

    /// <summary>
    /// Raises a horizon to the edges between a facet that faces the place and one that does not, and to those of the patch's border: over
    /// all others the ground rises on, or has fallen before.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void RaiseRidges(HorizonBuffer buffer, CellRange cells)
    {
        uint all = (1u << cells.Samples) - 1;
        uint before = 0;
        for (int line = 0; line < cells.Lines; line++)
        {
            int at = line * Stride;
            (uint southWest, uint northEast) = Facing(at);
            uint upper = line == 0 ? all : (northEast ^ before) & all;
            before = southWest;
            if (!MayRise(buffer, at, cells.Samples))
            {
                continue;
            }

            uint left = ((southWest ^ (northEast << 1)) & all) | 1;
            for (uint bits = upper; bits != 0; bits &= bits - 1)
            {
                int from = at + BitOperations.TrailingZeroCount(bits);
                buffer.Raise(this[from], this[from + 1]);
            }

            for (uint bits = left; bits != 0; bits &= bits - 1)
            {
                int from = at + BitOperations.TrailingZeroCount(bits);
                buffer.Raise(this[from], this[from + Stride]);
            }

            for (uint bits = (southWest ^ northEast) & all; bits != 0; bits &= bits - 1)
            {
                int from = at + BitOperations.TrailingZeroCount(bits);
                buffer.Raise(this[from], this[from + Stride + 1]);
            }

            buffer.Raise(this[at + cells.Samples], this[at + cells.Samples + Stride]);
            for (int sample = 0; line == cells.Lines - 1 && sample < cells.Samples; sample++)
            {
                buffer.Raise(this[at + Stride + sample], this[at + Stride + sample + 1]);
            }
        }
    }

    /// <summary>Which facets of the cells of a line face the place, the first cell in the lowest bit.</summary>
    private (uint SouthWest, uint NorthEast) Facing(int at)
    {
        (Vector512<double> x, Vector512<double> y, Vector512<double> z) = Corners(at); // north-west
        (Vector512<double> xe, Vector512<double> ye, Vector512<double> ze) = Corners(at + 1);
        (Vector512<double> xs, Vector512<double> ys, Vector512<double> zs) = Corners(at + Stride);
        (Vector512<double> xd, Vector512<double> yd, Vector512<double> zd) = Corners(at + Stride + 1);
        Vector512<double> alongX = (y * zd) - (z * yd);
        Vector512<double> alongY = (z * xd) - (x * zd);
        Vector512<double> alongZ = (x * yd) - (y * xd);
        Vector512<double> southWest = (xs * alongX) + (ys * alongY) + (zs * alongZ); // - det(NW, SW, SE)
        Vector512<double> northEast = (xe * alongX) + (ye * alongY) + (ze * alongZ); // det(NW, SE, NE)
        return (
            (uint)Vector512.GreaterThan(southWest, Vector512<double>.Zero).ExtractMostSignificantBits(),
            (uint)Vector512.LessThan(northEast, Vector512<double>.Zero).ExtractMostSignificantBits());
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (Vector512<double> X, Vector512<double> Y, Vector512<double> Z) Corners(int at) =>
        (Vector512.LoadUnsafe(ref _east[at]), Vector512.LoadUnsafe(ref _north[at]), Vector512.LoadUnsafe(ref _up[at]));

    private HorizonPoint this[int at] => new(_east[at], _north[at], _up[at], _columns[at], _tangents[at]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Along(
        Vector3D axis, double offset, Vector512<double> x, Vector512<double> y, Vector512<double> z) =>
        Vector512.Create(offset) + (Vector512.Create(axis.X) * x) + (Vector512.Create(axis.Y) * y) + (Vector512.Create(axis.Z) * z);

    /// <summary>Whether an edge of some cells of a line may rise above the horizon.</summary>
    private bool MayRise(HorizonBuffer buffer, int at, int cells)
    {
        (float first, float last, float highest) = (float.PositiveInfinity, float.NegativeInfinity, float.NegativeInfinity);
        for (int from = at; from <= at + Stride; from += Stride)
        {
            for (int i = from; i <= from + cells; i++)
            {
                float column = _columns[i];
                (first, last) = (column < first ? column : first, column > last ? column : last);
                highest = _tangents[i] > highest ? _tangents[i] : highest;
            }
        }

        return last - first > 0.25f * buffer.Columns // perhaps across the north
            || buffer.HighestOf(highest, last - first) > buffer.LeastFrom((int)first & (buffer.Columns - 1), (int)(last - first) + 2);
    }
}
