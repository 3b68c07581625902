using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The planes of eight neighbouring cells' facets. One over the parameter at which a pixel's ray meets a plane is linear in column and row;
/// it is held between the values at the facet's corners, so that a facet that is seen edge-on has no wild depth.
/// </summary>
internal sealed class FacetPlanes
{
    private const int Lanes = 8;
    private const int NormalX = 0;
    private const int NormalY = Lanes;
    private const int NormalZ = 2 * Lanes;
    private const int Constant = 3 * Lanes;
    private const int PerColumn = 4 * Lanes;
    private const int PerRow = 5 * Lanes;
    private const int Least = 6 * Lanes;
    private const int Greatest = 7 * Lanes;
    private const int Offset = 8 * Lanes;
    private const int HalfSize = 9 * Lanes;
    private const int NotRecorded = -1;

    private readonly double[] _values = new double[2 * HalfSize];
    private readonly int[] _numbers = new int[2 * Lanes];

    private PictureView _view = null!;
    private Vector512<double> _distance;
    private int _line;
    private int _sample;
    private int _made;

    /// <summary>Takes a frame's camera.</summary>
    public void Begin(PictureView view)
    {
        _view = view;
        _distance = Vector512.Create(view.Distance);
    }

    /// <summary>Goes to other cells; their planes are computed when they are asked for.</summary>
    /// <param name="line">Line of the cells.</param>
    /// <param name="sample">Sample of the westernmost one.</param>
    public void MoveTo(int line, int sample)
    {
        _line = line;
        _sample = sample;
        _made = 0;
    }

    /// <summary>Computes the planes of one half of the cells, unless that is done.</summary>
    /// <param name="block">The cells' block.</param>
    /// <param name="index">Element of the westernmost cell's north-western vertex.</param>
    /// <param name="half">0: south-western facets, 1: north-eastern ones.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Require(ProjectedBlock block, int index, int half)
    {
        if ((_made & (1 << half)) == 0)
        {
            Make(block, index, half);
        }
    }

    /// <summary>One over the ray parameters at eight pixels, each on the plane of its own cell's facet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> InverseParameters(int half, Vector512<double> columns, Vector512<double> rows)
    {
        ref double values = ref Values(half, 0);
        Vector512<double> value = (Vector512.LoadUnsafe(ref values, Constant) + (Vector512.LoadUnsafe(ref values, PerRow) * rows))
            + (Vector512.LoadUnsafe(ref values, PerColumn) * columns);
        return Held(value, Vector512.LoadUnsafe(ref values, Least), Vector512.LoadUnsafe(ref values, Greatest));
    }

    /// <summary>The plane of one cell's facet, for pixels of its own.</summary>
    public FacetPlane Plane(int half, int lane)
    {
        ref double values = ref Values(half, lane);
        return new FacetPlane(
            Unsafe.Add(ref values, Constant),
            Unsafe.Add(ref values, PerColumn),
            Unsafe.Add(ref values, PerRow),
            Unsafe.Add(ref values, Least),
            Unsafe.Add(ref values, Greatest));
    }

    /// <summary>Number of a cell's facet in the band's records; it is recorded when it is first asked for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int NumberIn(Band band, int half, int lane)
    {
        ref int number = ref _numbers[(half * Lanes) + lane];
        return number == NotRecorded ? number = band.Add(Record(half, lane)) : number;
    }

    /// <summary>What is recorded of a cell's facet.</summary>
    public FacetRecord Record(int half, int lane)
    {
        ref double values = ref Values(half, lane);
        Vector3D normal = new(values, Unsafe.Add(ref values, NormalY), Unsafe.Add(ref values, NormalZ));
        return new FacetRecord(normal, Unsafe.Add(ref values, Offset), _line, (2 * (_sample + lane)) + half);
    }

    /// <summary>Holds values within limits; what is no number becomes the lower limit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Held(Vector512<double> value, Vector512<double> least, Vector512<double> greatest) =>
        Vector512.MinNative(Vector512.MaxNative(value, least), greatest);

    private ref double Values(int half, int element) =>
        ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(_values), (half * HalfSize) + element);

    private void Make(ProjectedBlock block, int index, int half)
    {
        _made |= 1 << half;
        _numbers.AsSpan(half * Lanes, Lanes).Fill(NotRecorded);
        nuint a = (nuint)index;
        nuint b = (nuint)(index + ProjectedBlock.Stride + half);
        nuint c = (nuint)(half == 0 ? index + ProjectedBlock.Stride + 1 : index + 1);
        ref double x = ref MemoryMarshal.GetArrayDataReference(block.Vertices.X);
        ref double y = ref MemoryMarshal.GetArrayDataReference(block.Vertices.Y);
        ref double z = ref MemoryMarshal.GetArrayDataReference(block.Vertices.Z);
        Vector512<double> ax = Vector512.LoadUnsafe(ref x, a);
        Vector512<double> ay = Vector512.LoadUnsafe(ref y, a);
        Vector512<double> az = Vector512.LoadUnsafe(ref z, a);
        Vector512<double> ux = Vector512.LoadUnsafe(ref x, b) - ax;
        Vector512<double> uy = Vector512.LoadUnsafe(ref y, b) - ay;
        Vector512<double> uz = Vector512.LoadUnsafe(ref z, b) - az;
        Vector512<double> vx = Vector512.LoadUnsafe(ref x, c) - ax;
        Vector512<double> vy = Vector512.LoadUnsafe(ref y, c) - ay;
        Vector512<double> vz = Vector512.LoadUnsafe(ref z, c) - az;
        Vector512<double> nx = (uy * vz) - (uz * vy);
        Vector512<double> ny = (uz * vx) - (ux * vz);
        Vector512<double> nz = (ux * vy) - (uy * vx);
        Vector512<double> inverse = Vector512<double>.One / (Dot(nx, ny, nz, ax, ay, az) - Dot(nx, ny, nz, _view.Remainder));
        ref double values = ref Values(half, 0);
        nx.StoreUnsafe(ref values, NormalX);
        ny.StoreUnsafe(ref values, NormalY);
        nz.StoreUnsafe(ref values, NormalZ);
        Vector3D shift = _view.Origin - _view.Anchor;
        Dot(nx, ny, nz, ax + Vector512.Create(shift.X), ay + Vector512.Create(shift.Y), az + Vector512.Create(shift.Z)).StoreUnsafe(ref values, Offset);
        (Dot(nx, ny, nz, _view.FirstRay) * inverse).StoreUnsafe(ref values, Constant);
        (Dot(nx, ny, nz, _view.RayPerColumn) * inverse).StoreUnsafe(ref values, PerColumn);
        (Dot(nx, ny, nz, _view.RayPerRow) * inverse).StoreUnsafe(ref values, PerRow);

        ref double inverseDepth = ref MemoryMarshal.GetArrayDataReference(block.InverseDepth);
        Vector512<double> atA = Vector512.LoadUnsafe(ref inverseDepth, a);
        Vector512<double> atB = Vector512.LoadUnsafe(ref inverseDepth, b);
        Vector512<double> atC = Vector512.LoadUnsafe(ref inverseDepth, c);
        (_distance * Vector512.MinNative(atA, Vector512.MinNative(atB, atC))).StoreUnsafe(ref values, Least);
        (_distance * Vector512.MaxNative(atA, Vector512.MaxNative(atB, atC))).StoreUnsafe(ref values, Greatest);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Dot(
        Vector512<double> x, Vector512<double> y, Vector512<double> z, Vector512<double> u, Vector512<double> v, Vector512<double> w) =>
        (x * u) + (y * v) + (z * w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Dot(Vector512<double> x, Vector512<double> y, Vector512<double> z, Vector3D other) =>
        Dot(x, y, z, Vector512.Create(other.X), Vector512.Create(other.Y), Vector512.Create(other.Z));
}
