using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Illumination;

/// <summary>The vertices of a patch of 8 x 8 cells as they are seen from a place, an array for each coordinate.</summary>
internal sealed class PatchPoints
{
    /// <summary>Cells along an edge of a patch.</summary>
    public const int Cells = 8;

    /// <summary>Elements from one line of vertices to the next: 9 in two vectors.</summary>
    private const int Stride = 2 * Cells;

    private readonly double[] _east = new double[(Cells + 2) * Stride];
    private readonly double[] _north = new double[(Cells + 2) * Stride];
    private readonly double[] _up = new double[(Cells + 2) * Stride];
    private readonly float[] _columns = new float[(Cells + 2) * Stride];
    private readonly float[] _tangents = new float[(Cells + 2) * Stride];
    private readonly uint[] _high = new uint[Cells + 1];

    /// <summary>Turns the vertices of a patch, and finds the tangents of their elevations.</summary>
    /// <param name="vertices">Those of its block.</param>
    /// <param name="origin">To which they are relative, m, body-fixed.</param>
    /// <param name="top">Line of the patch in the block.</param>
    /// <param name="left">Its sample.</param>
    /// <param name="cells">Its cells.</param>
    /// <param name="frame">The place.</param>
    /// <returns>The greatest tangent.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public float Place(BlockVertices vertices, Vector3D origin, int top, int left, CellRange cells, in LocalFrame frame)
    {
        Vector3D start = frame.ToLocal(origin - frame.PositionBodyFixed);
        Vector512<float> lowest = Vector512.Create(HorizonPoint.Lowest);
        Vector512<float> highest = lowest;
        Vector512<float> isVertex = Vector512.LessThanOrEqual(Vector512<int>.Indices, Vector512.Create(cells.Samples)).AsSingle();
        for (int line = 0; line <= cells.Lines; line++)
        {
            int from = ((top + line) * BlockVertices.Stride) + left;
            int to = line * Stride;
            Turn(vertices, from, start, frame, to);
            Turn(vertices, from + Cells, start, frame, to + Cells);

            // Relative to the place, so that floats have digits enough.
            (Vector512<float> east, Vector512<float> north) = Across(to);
            Vector512<float> up = Narrow(_up, to);
            Vector512<float> across = Vector512.Sqrt((east * east) + (north * north));
            Vector512<float> tangent = Vector512.MaxNative(up / Vector512.MaxNative(across, Vector512.Create(1e-9f)), lowest);
            tangent = Vector512.ConditionalSelect(isVertex, tangent, lowest);
            highest = Vector512.MaxNative(highest, tangent);
            tangent.StoreTo(_tangents, to);
        }

        return LaneMasks.Max(highest);
    }

    /// <summary>Finds the azimuths of the vertices that were turned last.</summary>
    /// <param name="lines">Lines of vertices.</param>
    /// <param name="columns">Columns of a turn.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void FindColumns(int lines, int columns)
    {
        for (int line = 0; line < lines; line++)
        {
            (Vector512<float> east, Vector512<float> north) = Across(line * Stride);
            (AzimuthLanes.Turns(east, north) * Vector512.Create((float)columns)).StoreTo(_columns, line * Stride);
        }
    }

    /// <summary>Finds the vertices at which an edge that rises above a horizon may end; all of them if windows are too narrow.</summary>
    /// <param name="windows">Windows of the horizon; null to look at all vertices.</param>
    /// <param name="cells">The patch's cells.</param>
    /// <returns>Whether there are any.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public bool FindHigh(HorizonWindows? windows, CellRange cells)
    {
        uint all = (2u << cells.Samples) - 1;
        float[]? least = windows?.For(WidestOf(cells));
        uint any = 0;
        for (int line = 0; line <= cells.Lines; line++)
        {
            uint high = all;
            if (least is not null)
            {
                Vector512<float> tangent = ArrayLanes.Load(_tangents, line * Stride);
                Vector512<int> column = Vector512.ConvertToInt32(ArrayLanes.Load(_columns, line * Stride));
                Vector512<float> horizon = HorizonTable.Gather(least, column & Vector512.Create(least.Length - 1));
                Vector512<float> bulge = Vector512.Create(HorizonBuffer.NarrowBulge) * Vector512.Abs(tangent);
                high = (uint)Vector512.GreaterThan(tangent + bulge, horizon).ExtractMostSignificantBits() & all;
            }

            any |= _high[line] = high;
        }

        return any != 0;
    }

    /// <summary>Columns from one end to the other of the patch's widest edge; very many across the north.</summary>
    private float WidestOf(CellRange cells)
    {
        Vector512<int> index = Vector512<int>.Indices;
        Vector512<float> isVertex = Vector512.LessThanOrEqual(index, Vector512.Create(cells.Samples)).AsSingle();
        Vector512<float> isCell = Vector512.LessThan(index, Vector512.Create(cells.Samples)).AsSingle();
        Vector512<float> widest = Vector512<float>.Zero;
        for (int at = 0; at < cells.Lines * Stride; at += Stride)
        {
            Vector512<float> here = ArrayLanes.Load(_columns, at);
            Vector512<float> below = Vector512.Abs(ArrayLanes.Load(_columns, at + Stride) - here);
            Vector512<float> right = Vector512.Abs(ArrayLanes.Load(_columns, at + 1) - here);
            Vector512<float> across = Vector512.Abs(ArrayLanes.Load(_columns, at + Stride + 1) - here);
            widest = Vector512.MaxNative(widest, below & isVertex);
            widest = Vector512.MaxNative(widest, Vector512.MaxNative(right, across) & isCell);
        }

        Vector512<float> last = ArrayLanes.Load(_columns, cells.Lines * Stride);
        Vector512<float> lastRight = ArrayLanes.Load(_columns, (cells.Lines * Stride) + 1);
        return LaneMasks.Max(Vector512.MaxNative(widest, Vector512.Abs(lastRight - last) & isCell));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (Vector512<float> East, Vector512<float> North) Across(int at) => (Narrow(_east, at), Narrow(_north, at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> Narrow(double[] values, int at) =>
        Vector512.Narrow(ArrayLanes.Load(values, at), ArrayLanes.Load(values, at + Cells));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Turn(BlockVertices vertices, int from, Vector3D start, in LocalFrame frame, int to)
    {
        Vector512<double> x = ArrayLanes.Load(vertices.X, from);
        Vector512<double> y = ArrayLanes.Load(vertices.Y, from);
        Vector512<double> z = ArrayLanes.Load(vertices.Z, from);
        Along(frame.East, start.X, x, y, z).StoreTo(_east, to);
        Along(frame.North, start.Y, x, y, z).StoreTo(_north, to);
        Along(frame.Up, start.Z, x, y, z).StoreTo(_up, to);
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
            RaiseRidges(buffer, cells, part.Mesh.Cells);
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
    /// Raises a horizon to the ridges of the patch: edges of a facet that faces the place, over which that facet does not rise, and beyond
    /// which the next one does not face the place. Over all others the ground rises on, or has fallen before. Only one facet of an edge
    /// on the patch's border is known: the edge is raised by the patch whose facet faces the place, and on the border of the model always.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void RaiseRidges(HorizonBuffer buffer, CellRange cells, CellRange mesh)
    {
        uint all = (1u << cells.Samples) - 1;
        uint leftEnd = cells.FirstSample == mesh.FirstSample ? 1u : 0;
        bool rightEnd = cells.EndSample == mesh.EndSample;
        uint topEnd = cells.FirstLine == mesh.FirstLine ? all : 0;
        uint before = 0;
        bool mayRise = false;
        for (int line = 0; line < cells.Lines; line++)
        {
            int at = line * Stride;
            bool mayRiseAbove = mayRise;
            (uint high, uint highBelow) = (_high[line], _high[line + 1]);
            mayRise = (high | highBelow) != 0 && MayRise(buffer, at, cells.Samples);
            if (!mayRise)
            {
                continue;
            }

            CellLine facets = LineOf(at);
            (uint southWest, uint northEast) = (facets.SouthWest & all, facets.NorthEast & all);
            uint top = line == 0 ? (northEast & facets.TopRight) | topEnd
                : mayRiseAbove ? (northEast & ~before & facets.TopRight) | (before & ~northEast & ~facets.TopRight)
                : 0;
            uint left = (southWest & ~(northEast << 1) & ~facets.LeftRight) | ((northEast << 1) & ~southWest & facets.LeftRight) | leftEnd;
            uint across = (southWest & ~northEast & facets.AcrossRight) | (northEast & ~southWest & ~facets.AcrossRight);
            bool hasRight = rightEnd || ((northEast >> (cells.Samples - 1)) != 0 && IsToRight(at + cells.Samples));
            before = southWest;
            uint ends = high | highBelow;
            RaiseAll(buffer, at, top & (high | (high >> 1)), 1);
            RaiseAll(buffer, at, left & all & ends, Stride);
            RaiseAll(buffer, at, across & (high | (highBelow >> 1)), Stride + 1);
            RaiseAll(buffer, at + cells.Samples, hasRight ? (ends >> cells.Samples) & 1 : 0u, Stride);
        }

        int last = cells.Lines * Stride;
        uint bottom = !mayRise ? 0 : cells.EndLine == mesh.EndLine ? all : before & ~LineOf(last).TopRight;
        RaiseAll(buffer, last, bottom & all, 1);
    }

    /// <summary>Raises a horizon to edges from some of the vertices of a line to those that come a number of elements later.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void RaiseAll(HorizonBuffer buffer, int at, uint vertices, int later)
    {
        for (uint bits = vertices; bits != 0; bits &= bits - 1)
        {
            int from = at + BitOperations.TrailingZeroCount(bits);
            int to = from + later;
            if (!buffer.TryRaise(_columns[from], _tangents[from], _columns[to], _tangents[to]))
            {
                buffer.Raise(this[from], this[to]);
            }
        }
    }

    /// <summary>Whether the vertex below one is seen to the right of it.</summary>
    private bool IsToRight(int at) => _east[at + Stride] * _north[at] > _north[at + Stride] * _east[at];

    /// <summary>How the cells of a line are seen, the first one in the lowest bit.</summary>
    private CellLine LineOf(int at)
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
        return new CellLine(
            Bits(Vector512.GreaterThan(southWest, Vector512<double>.Zero)), Bits(Vector512.LessThan(northEast, Vector512<double>.Zero)),
            Bits(Vector512.GreaterThan(xe * y, ye * x)), Bits(Vector512.GreaterThan(xs * y, ys * x)),
            Bits(Vector512.LessThan(alongZ, Vector512<double>.Zero)));

        static uint Bits(Vector512<double> mask) => (uint)mask.ExtractMostSignificantBits();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (Vector512<double> X, Vector512<double> Y, Vector512<double> Z) Corners(int at) =>
        (ArrayLanes.Load(_east, at), ArrayLanes.Load(_north, at), ArrayLanes.Load(_up, at));

    private HorizonPoint this[int at] => new(_east[at], _north[at], _up[at], _columns[at], _tangents[at]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Along(
        Vector3D axis, double offset, Vector512<double> x, Vector512<double> y, Vector512<double> z) =>
        Vector512.Create(offset) + (Vector512.Create(axis.X) * x) + (Vector512.Create(axis.Y) * y) + (Vector512.Create(axis.Z) * z);

    /// <summary>Whether an edge of some cells of a line may rise above the horizon.</summary>
    private bool MayRise(HorizonBuffer buffer, int at, int cells)
    {
        Vector512<float> columns = ArrayLanes.Load(_columns, at);
        Vector512<float> columnsBelow = ArrayLanes.Load(_columns, at + Stride);
        Vector512<float> isVertex = Vector512.LessThanOrEqual(Vector512<int>.Indices, Vector512.Create(cells)).AsSingle();
        Vector512<float> any = Vector512.Create(columns[0]);
        float first = LaneMasks.Min(Vector512.ConditionalSelect(isVertex, Vector512.MinNative(columns, columnsBelow), any));
        float width = LaneMasks.Max(Vector512.ConditionalSelect(isVertex, Vector512.MaxNative(columns, columnsBelow), any)) - first;
        Vector512<float> tangents = Vector512.MaxNative(ArrayLanes.Load(_tangents, at), ArrayLanes.Load(_tangents, at + Stride));
        float highest = LaneMasks.Max(Vector512.ConditionalSelect(isVertex, tangents, Vector512.Create(HorizonPoint.Lowest)));
        return width > 0.25f * buffer.Columns // perhaps across the north
            || buffer.HighestOf(highest, width) > buffer.LeastFrom((int)first & (buffer.Columns - 1), (int)width + 2);
    }

    /// <summary>How the cells of a line are seen, a bit for each: facets that face the place, and edges that lead over east.</summary>
    /// <param name="SouthWest">Whether the facet of the north-west, south-west and south-east corner faces the place.</param>
    /// <param name="NorthEast">Whether the other one does.</param>
    /// <param name="TopRight">Whether the north-east corner is seen to the right of the north-west one.</param>
    /// <param name="LeftRight">Whether the south-west corner is.</param>
    /// <param name="AcrossRight">Whether the south-east corner is.</param>
    private readonly record struct CellLine(uint SouthWest, uint NorthEast, uint TopRight, uint LeftRight, uint AcrossRight);
}
