using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The points of the Sun's disc in light space. The rays to one of them are parallel there too: with each metre towards the Sun they
/// move across by the same (a, b). Adding (a, b) w to (u, v) makes them parallel to the axis, so a point of the disc is treated as its
/// centre is, in coordinates of its own.
/// </summary>
internal sealed class DiscRays
{
    private readonly double[] _a = new double[SunDisc.Points];
    private readonly double[] _b = new double[SunDisc.Points];
    private readonly double _slope;

    public DiscRays(SunDisc disc, LightFrame frame)
    {
        _slope = disc.Slope;
        for (int i = 0; i < SunDisc.Points; i++)
        {
            Vector3D offset = disc.PointsMoonMe[i] - disc.CentreMoonMe;
            _a[i] = Vector3D.Dot(offset, frame.AxisU) / frame.SunDistance;
            _b[i] = Vector3D.Dot(offset, frame.AxisV) / frame.SunDistance;
        }
    }

    /// <summary>The points of the disc that a facet hides.</summary>
    /// <param name="facet">The facet.</param>
    /// <param name="point">In light space.</param>
    /// <remarks>
    /// The edge functions of <see cref="CellStrip.IsInFrontOf"/> are linear in (a, b), and the facet's depth against the point's does not
    /// depend on it: it only tells the side of the facet's plane.
    /// </remarks>
    public ulong HiddenBy(in LightFacet facet, Vector3D point)
    {
        Vector3D a = new(facet.Ua - point.X, facet.Va - point.Y, facet.Wa - point.Z);
        Vector3D b = new(facet.Ub - point.X, facet.Vb - point.Y, facet.Wb - point.Z);
        Vector3D c = new(facet.Uc - point.X, facet.Vc - point.Y, facet.Wc - point.Z);
        Edge bc = new(b, c);
        Edge ca = new(c, a);
        Edge ab = new(a, b);
        bool isDeeper = (bc.Value * a.Z) + (ca.Value * b.Z) + (ab.Value * c.Z) < 0.0;
        if (!isDeeper || bc.Greatest(_slope) < 0.0 || ca.Greatest(_slope) < 0.0 || ab.Greatest(_slope) < 0.0)
        {
            return 0;
        }

        ulong hidden = 0;
        ref double alongU = ref MemoryMarshal.GetArrayDataReference(_a);
        ref double alongV = ref MemoryMarshal.GetArrayDataReference(_b);
        for (int i = 0; i < SunDisc.Points; i += Vector512<double>.Count)
        {
            Vector512<double> u = Vector512.LoadUnsafe(ref alongU, (nuint)i);
            Vector512<double> v = Vector512.LoadUnsafe(ref alongV, (nuint)i);
            Vector512<double> least = Vector512.MinNative(bc.At(u, v), Vector512.MinNative(ca.At(u, v), ab.At(u, v)));
            hidden |= Vector512.GreaterThanOrEqual(least, Vector512<double>.Zero).ExtractMostSignificantBits() << i;
        }

        return hidden;
    }

    /// <summary>The edge function of two corners, relative to the point: exactly antisymmetric in them.</summary>
    private readonly struct Edge(Vector3D first, Vector3D second)
    {
        private readonly double _perA = (first.Z * second.Y) - (second.Z * first.Y);
        private readonly double _perB = (first.X * second.Z) - (second.X * first.Z);

        public double Value { get; } = (first.X * second.Y) - (second.X * first.Y);

        public double Greatest(double slope) => Value + (1.0001 * slope * Math.Sqrt((_perA * _perA) + (_perB * _perB)));

        public Vector512<double> At(Vector512<double> a, Vector512<double> b) =>
            Vector512.Create(Value) + ((Vector512.Create(_perA) * a) + (Vector512.Create(_perB) * b));
    }
}
