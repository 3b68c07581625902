using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Up to sixteen boxes that a ray is tested against at once. They are kept as floats and wider than they were set: a test may say yes
/// where a ray passes close by, but never no where it meets a box.
/// </summary>
internal sealed class SixteenBoxes
{
    /// <summary>Number of boxes.</summary>
    public const int Count = 16;

    /// <summary>m: by how much a box is wider, beside <see cref="RelativeMargin"/>: several roundings of floats at 300 km.</summary>
    private const double Margin = 0.25;

    private const double RelativeMargin = 1e-6;

    /// <summary>m: where a box lies that is not set; no ray gets there.</summary>
    private const float Nowhere = 1e30f;

    private readonly float[] _limits = new float[6 * Count];

    /// <summary>Makes boxes of which none is set.</summary>
    public SixteenBoxes() => Array.Fill(_limits, Nowhere);

    /// <summary>Sets a box; m.</summary>
    public void Set(int box, Vector3D low, Vector3D high)
    {
        SetAxis(box, 0, low.X, high.X);
        SetAxis(box, 1, low.Y, high.Y);
        SetAxis(box, 2, low.Z, high.Z);
    }

    /// <summary>The boxes that a ray may meet before its end, as bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public uint Meet(in GroundRay ray)
    {
        ref float limits = ref MemoryMarshal.GetArrayDataReference(_limits);
        Vector512<float> ox = Vector512.Create((float)ray.Origin.X);
        Vector512<float> oy = Vector512.Create((float)ray.Origin.Y);
        Vector512<float> oz = Vector512.Create((float)ray.Origin.Z);
        Vector512<float> px = Vector512.Create(ray.PerX);
        Vector512<float> py = Vector512.Create(ray.PerY);
        Vector512<float> pz = Vector512.Create(ray.PerZ);
        Vector512<float> x1 = (Vector512.LoadUnsafe(ref limits) - ox) * px;
        Vector512<float> x2 = (Vector512.LoadUnsafe(ref limits, Count) - ox) * px;
        Vector512<float> y1 = (Vector512.LoadUnsafe(ref limits, 2 * Count) - oy) * py;
        Vector512<float> y2 = (Vector512.LoadUnsafe(ref limits, 3 * Count) - oy) * py;
        Vector512<float> z1 = (Vector512.LoadUnsafe(ref limits, 4 * Count) - oz) * pz;
        Vector512<float> z2 = (Vector512.LoadUnsafe(ref limits, 5 * Count) - oz) * pz;
        Vector512<float> near = Vector512.MaxNative(
            Vector512.MaxNative(Vector512.MinNative(x1, x2), Vector512.MinNative(y1, y2)),
            Vector512.MaxNative(Vector512.MinNative(z1, z2), Vector512<float>.Zero));
        Vector512<float> far = Vector512.MinNative(
            Vector512.MinNative(Vector512.MaxNative(x1, x2), Vector512.MaxNative(y1, y2)),
            Vector512.MinNative(Vector512.MaxNative(z1, z2), Vector512.Create((float)ray.End + 1.0f)));
        return (uint)Vector512.LessThanOrEqual(near, far).ExtractMostSignificantBits();
    }

    private void SetAxis(int box, int axis, double low, double high)
    {
        _limits[(2 * axis * Count) + box] = (float)(low - Margin - (RelativeMargin * Math.Abs(low)));
        _limits[(((2 * axis) + 1) * Count) + box] = (float)(high + Margin + (RelativeMargin * Math.Abs(high)));
    }
}
