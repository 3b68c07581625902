using System.Diagnostics;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The directions to the points of the Sun's disc in light space. All rays to one of these points are parallel in light space: with each
/// metre towards the Sun they move across by the same (a, b). Adding (a, b) w to (u, v) makes them parallel to the w axis, so each point
/// of the disc can be treated like the disc's centre.
/// </summary>
internal sealed class DiscRays
{
    /// <summary>Dimensionless factor that widens the reach of a sector, so that rounding errors cannot exclude one of its points.</summary>
    private const double ReachMargin = 1.0001;

    private const int Sectors = SunDisc.Points / SunDisc.PointsPerSector;

    private readonly double[] _a = new double[SunDisc.Points];
    private readonly double[] _b = new double[SunDisc.Points];
    private readonly double[] _sectorA = new double[Sectors];
    private readonly double[] _sectorB = new double[Sectors];
    private readonly double[] _sectorReach = new double[Sectors];

    public DiscRays(SunDisc disc, LightFrame frame)
    {
        for (int i = 0; i < SunDisc.Points; i++)
        {
            Vector3D offset = disc.PointsMoonMe[i] - disc.CentreMoonMe;
            _a[i] = Vector3D.Dot(offset, frame.AxisU) / frame.SunDistance;
            _b[i] = Vector3D.Dot(offset, frame.AxisV) / frame.SunDistance;
        }

        for (int sector = 0; sector < Sectors; sector++)
        {
            Range points = (sector * SunDisc.PointsPerSector)..((sector + 1) * SunDisc.PointsPerSector);
            double a = _a[points].Average();
            double b = _b[points].Average();
            (_sectorA[sector], _sectorB[sector]) = (a, b);
            _sectorReach[sector] = ReachMargin * _a[points].Zip(_b[points], (pa, pb) => double.Hypot(pa - a, pb - b)).Max();
        }
    }

    /// <summary>Mask of the points of the disc that a facet hides from a point.</summary>
    /// <param name="vertices">Vertices of a block in light space, m.</param>
    /// <param name="a">Index of the vertex at the facet's first corner.</param>
    /// <param name="b">Index of the vertex at the next corner.</param>
    /// <param name="c">Index of the vertex at the last corner.</param>
    /// <param name="point">The point in light space, m.</param>
    /// <param name="wanted">Mask of the points of the disc to test; the result may contain other hidden points too.</param>
    /// <remarks>
    /// The edge functions of <see cref="CellStrip.IsInFrontOf"/> are linear in (a, b). The sign of the depth sum does not depend on (a, b),
    /// because it only tells on which side of the facet's plane the point is.
    /// </remarks>
    public ulong HiddenBy(BlockVertices vertices, int a, int b, int c, Vector3D point, ulong wanted)
    {
        // A lane for each edge: ab, bc, ca.
        Vector256<double> u = Corners(vertices.X, a, b, c) - Vector256.Create(point.X);
        Vector256<double> v = Corners(vertices.Y, a, b, c) - Vector256.Create(point.Y);
        Vector256<double> w = Corners(vertices.Z, a, b, c) - Vector256.Create(point.Z);
        Vector256<double> nextU = Vector256.Shuffle(u, Vector256.Create(1L, 2L, 0L, 3L));
        Vector256<double> nextV = Vector256.Shuffle(v, Vector256.Create(1L, 2L, 0L, 3L));
        Vector256<double> nextW = Vector256.Shuffle(w, Vector256.Create(1L, 2L, 0L, 3L));
        Vector256<double> value = (u * nextV) - (nextU * v);
        Vector256<double> depths = value * Vector256.Shuffle(w, Vector256.Create(2L, 0L, 1L, 3L));
        if (!(depths[1] + depths[2] + depths[0] < 0.0))
        {
            return 0;
        }

        Vector256<double> perA = (w * nextV) - (nextW * v);
        Vector256<double> perB = (u * nextW) - (nextU * w);
        Edges edges = new(value, perA, perB);
        Vector256<double> maxSlope = Vector256.Sqrt((perA * perA) + (perB * perB));
        Vector512<double> reach = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(_sectorReach));
        uint sectors = edges.AreNotNegative(_sectorA, _sectorB, 0, reach, maxSlope);
        ulong hidden = 0;
        for (; sectors != 0; sectors &= sectors - 1)
        {
            int first = BitOperations.TrailingZeroCount(sectors) * SunDisc.PointsPerSector;
            if ((byte)(wanted >> first) != 0)
            {
                hidden |= (ulong)edges.AreNotNegative(_a, _b, first) << first;
            }
        }

        return hidden;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Corners(double[] coordinates, int a, int b, int c)
    {
        Debug.Assert(Math.Max(a, Math.Max(b, c)) < coordinates.Length
            && Math.Min(a, Math.Min(b, c)) >= 0, "A facet lies outside its block.");
        ref double first = ref MemoryMarshal.GetArrayDataReference(coordinates);
        return Vector256.Create(Unsafe.Add(ref first, a), Unsafe.Add(ref first, b), Unsafe.Add(ref first, c), 0.0);
    }

    /// <summary>The three edge functions of a facet as linear functions of (a, b).</summary>
    private readonly struct Edges(Vector256<double> value, Vector256<double> perA, Vector256<double> perB)
    {
        /// <summary>Mask of eight (a, b) for which no edge function is negative anywhere within a reach around it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public uint AreNotNegative(double[] alongA, double[] alongB, int first, Vector512<double> reach, Vector256<double> maxSlope)
        {
            Vector512<double> a = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(alongA), (nuint)first);
            Vector512<double> b = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(alongB), (nuint)first);
            Vector512<double> min = Vector512.MinNative(
                At(0, a, b) + (reach * Vector512.Create(maxSlope[0])),
                Vector512.MinNative(
                    At(1, a, b) + (reach * Vector512.Create(maxSlope[1])), At(2, a, b) + (reach * Vector512.Create(maxSlope[2]))));
            return (uint)Vector512.GreaterThanOrEqual(min, Vector512<double>.Zero).ExtractMostSignificantBits();
        }

        /// <summary>Mask of eight (a, b) for which no edge function is negative.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public uint AreNotNegative(double[] alongA, double[] alongB, int first)
        {
            Vector512<double> a = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(alongA), (nuint)first);
            Vector512<double> b = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(alongB), (nuint)first);
            Vector512<double> min = Vector512.MinNative(At(0, a, b), Vector512.MinNative(At(1, a, b), At(2, a, b)));
            return (uint)Vector512.GreaterThanOrEqual(min, Vector512<double>.Zero).ExtractMostSignificantBits();
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private Vector512<double> At(int edge, Vector512<double> a, Vector512<double> b) =>
            Vector512.Create(value[edge]) + ((Vector512.Create(perA[edge]) * a) + (Vector512.Create(perB[edge]) * b));
    }
}
