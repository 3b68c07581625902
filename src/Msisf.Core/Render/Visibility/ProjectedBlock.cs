using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>The vertices of one block, in space and projected into the image; one object is loaded for many blocks.</summary>
internal sealed class ProjectedBlock
{
    /// <summary>Number of array elements from one line of vertices to the next.</summary>
    public const int Stride = BlockVertices.Stride;

    private const int Rows = CellBlock.Size + 1;

    /// <summary>
    /// m: vertices of a smaller depth count as lying in the camera's plane. It is far above the numbers whose inverse is infinite.
    /// </summary>
    private const double MinDepth = 1e-200;

    private readonly double[] _tops = new double[Rows * Vector512<double>.Count];
    private readonly double[] _bottoms = new double[Rows * Vector512<double>.Count];
    private Vector3D _originFromAnchor;

    /// <summary>Positions of the vertices in m, body-fixed, relative to <see cref="ImageView.Origin"/>, not to the camera.</summary>
    public BlockVertices Vertices { get; } = new();

    /// <summary>Image columns of the vertices, px; line by line with <see cref="Stride"/> elements each.</summary>
    public double[] X { get; } = new double[Rows * Stride];

    /// <summary>Image rows of the vertices, px; ordered like <see cref="X"/>.</summary>
    public double[] Y { get; } = new double[Rows * Stride];

    /// <summary>1/m: inverse depths of the vertices; ordered like <see cref="X"/>.</summary>
    public double[] InverseDepth { get; } = new double[Rows * Stride];

    /// <summary>Whether all vertices lie in front of the camera and are projected within <see cref="ImageView.CoordinateLimit"/>.</summary>
    public bool IsInFront { get; private set; }

    /// <summary>
    /// The halves of a line's cells that are facets, as bits of <see cref="FacetCorners"/>; the cells of a polar fan have only one.
    /// </summary>
    public uint HalvesOf(int line)
    {
        if (Vertices.IsOfSeams)
        {
            return FacetCorners.SouthWestHalf;
        }

        int cellLine = Vertices.Cells.FirstLine + line;
        return cellLine < 0 ? FacetCorners.SouthWestHalf
            : cellLine == Vertices.SouthFanLine ? FacetCorners.NorthEastHalf
            : FacetCorners.SouthWestHalf | FacetCorners.NorthEastHalf;
    }

    /// <summary>Records a facet for the depth buffer.</summary>
    /// <param name="index">Index of the north-western vertex of the facet's cell.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    /// <param name="record">Receives it; a returned one would be copied right after it was written, for which processors wait.</param>
    public void Record(int index, int half, out FacetRecord record)
    {
        ref double x = ref BlockVertices.CornersFrom(Vertices.X, index);
        ref double y = ref BlockVertices.CornersFrom(Vertices.Y, index);
        ref double z = ref BlockVertices.CornersFrom(Vertices.Z, index);
        int second = FacetCorners.Second(half);
        int third = FacetCorners.Third(half);
        double ux = Unsafe.Add(ref x, second) - x;
        double uy = Unsafe.Add(ref y, second) - y;
        double uz = Unsafe.Add(ref z, second) - z;
        double vx = Unsafe.Add(ref x, third) - x;
        double vy = Unsafe.Add(ref y, third) - y;
        double vz = Unsafe.Add(ref z, third) - z;

        // The sides are exact, so plain products give the normal accurately unless the facet is almost a line.
        double nx = (uy * vz) - (uz * vy);
        double ny = (uz * vx) - (ux * vz);
        double nz = (ux * vy) - (uy * vx);
        double offset = (nx * (x + _originFromAnchor.X)) + (ny * (y + _originFromAnchor.Y)) + (nz * (z + _originFromAnchor.Z));
        if (Vertices.IsOfSeams)
        {
            record = new FacetRecord(
                new Vector3D(nx, ny, nz), offset, 0, FacetRecord.Place(Vertices.Block.Part, Vertices.SeamFacet(index), half));
            return;
        }

        int line = index / Stride;
        record = new FacetRecord(
            new Vector3D(nx, ny, nz), offset, Vertices.Cells.FirstLine + line,
            FacetRecord.Place(Vertices.Block.Part, Vertices.Cells.FirstSample + index - (line * Stride), half));
    }

    /// <summary>Position of a vertex in m, body-fixed, relative to <see cref="ImageView.Origin"/>.</summary>
    public Vector3D At(int index) => new(Vertices.X[index], Vertices.Y[index], Vertices.Z[index]);

    /// <summary>Reads the vertices of a block.</summary>
    public void Read(SurfaceModel surface, CellBlock block, ImageView view)
    {
        Vertices.Load(surface, block, view.Origin);
        _originFromAnchor = view.OriginFromAnchor;
    }

    /// <summary>Projects the block that was read.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise draw with unoptimised vectors
    public void Project(ImageView view)
    {
        Vector512<double> limit = Vector512.Create(view.CoordinateLimit);
        Vector512<double> one = Vector512<double>.One;
        Projection across = new(view.Across, view.Remainder);
        Projection down = new(view.Down, view.Remainder);
        Projection forward = new(view.Forward, view.Remainder);
        Vector512<double> centreX = Vector512.Create(view.CentreX);
        Vector512<double> centreY = Vector512.Create(view.CentreY);
        ReadOnlySpan<double> spaceX = Vertices.X;
        ReadOnlySpan<double> spaceY = Vertices.Y;
        ReadOnlySpan<double> spaceZ = Vertices.Z;
        Span<double> imageX = X;
        Span<double> imageY = Y;
        Span<double> inverseDepth = InverseDepth;
        Vector512<double> worst = Vector512<double>.Zero;
        Vector512<double> min = one;
        Vector512<double> noDepth = Vector512.Create(MinDepth);
        Vector512<double> lanes = Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
        for (int line = 0; line < Vertices.Lines; line++)
        {
            Vector512<double> top = Vector512.Create(double.PositiveInfinity);
            Vector512<double> bottom = Vector512.Create(double.NegativeInfinity);
            for (int sample = 0; sample < Vertices.Samples; sample += Vector512<double>.Count)
            {
                int index = (line * Stride) + sample;
                Vector512<double> sx = ArrayLanes.Load(spaceX, index);
                Vector512<double> sy = ArrayLanes.Load(spaceY, index);
                Vector512<double> sz = ArrayLanes.Load(spaceZ, index);
                Vector512<double> depth = forward.Of(sx, sy, sz);
                Vector512<double> inverse = one / depth;
                Vector512<double> x = (across.Of(sx, sy, sz) * inverse) + centreX;
                Vector512<double> y = (down.Of(sx, sy, sz) * inverse) + centreY;
                inverse.StoreTo(inverseDepth, index);
                x.StoreTo(imageX, index);
                y.StoreTo(imageY, index);
                if (sample + Vector512<double>.Count > Vertices.Samples)
                {
                    // What follows the line's vertices may lie anywhere: behind a camera near the ground, too.
                    Vector512<double> isVertex = Vector512.LessThan(lanes, Vector512.Create((double)(Vertices.Samples - sample)));
                    x = Vector512.ConditionalSelect(isVertex, x, Vector512.Create(x.ToScalar()));
                    y = Vector512.ConditionalSelect(isVertex, y, Vector512.Create(y.ToScalar()));
                    depth = Vector512.ConditionalSelect(isVertex, depth, one);
                }

                worst = Vector512.MaxNative(worst, Vector512.MaxNative(Vector512.Abs(x), Vector512.Abs(y)));
                min = Vector512.MinNative(min, depth);
                top = Vector512.MinNative(top, y);
                bottom = Vector512.MaxNative(bottom, y);
            }

            top.StoreTo(_tops, line * Vector512<double>.Count);
            bottom.StoreTo(_bottoms, line * Vector512<double>.Count);
        }

        IsInFront = Vector512.GreaterThanAll(min, noDepth) && Vector512.LessThanOrEqualAll(worst, limit);
    }

    /// <summary>
    /// Whether the vertex lies in front of the camera and its projection may be used; the result is the same in each block that has the
    /// vertex.
    /// </summary>
    public bool IsUsable(int index, ImageView view) =>
        InverseDepth[index] is > 0.0 and < 1.0 / MinDepth && Math.Abs(X[index]) <= view.CoordinateLimit
            && Math.Abs(Y[index]) <= view.CoordinateLimit;

    /// <summary>Whether a line of cells may touch some rows; valid only if the block is in front of the camera.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Touches(int line, double firstRow, double lastRow)
    {
        int north = line * Vector512<double>.Count;
        int south = north + Vector512<double>.Count;
        Vector512<double> top = Vector512.MinNative(ArrayLanes.Load(_tops, north), ArrayLanes.Load(_tops, south));
        Vector512<double> bottom = Vector512.MaxNative(
            ArrayLanes.Load(_bottoms, north), ArrayLanes.Load(_bottoms, south));
        return Vector512.LessThanOrEqualAny(top, Vector512.Create(lastRow))
            && Vector512.GreaterThanOrEqualAny(bottom, Vector512.Create(firstRow));
    }

    private readonly struct Projection(Vector3D axis, Vector3D remainder)
    {
        private readonly Vector512<double> _x = Vector512.Create(axis.X);
        private readonly Vector512<double> _y = Vector512.Create(axis.Y);
        private readonly Vector512<double> _z = Vector512.Create(axis.Z);
        private readonly Vector512<double> _shift = Vector512.Create(Vector3D.Dot(axis, remainder));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector512<double> Of(Vector512<double> x, Vector512<double> y, Vector512<double> z) =>
            ((x * _x) + (y * _y) + (z * _z)) - _shift;
    }
}
