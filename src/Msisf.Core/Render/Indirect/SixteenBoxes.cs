using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

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

    /// <summary>Where ways of a fan end, over their length: a little behind, because lengths are rounded.</summary>
    private const float End = 1.001f;

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
        ReadOnlySpan<float> limits = _limits;
        Vector512<float> ox = Vector512.Create((float)ray.Origin.X);
        Vector512<float> oy = Vector512.Create((float)ray.Origin.Y);
        Vector512<float> oz = Vector512.Create((float)ray.Origin.Z);
        Vector512<float> px = Vector512.Create(ray.PerX);
        Vector512<float> py = Vector512.Create(ray.PerY);
        Vector512<float> pz = Vector512.Create(ray.PerZ);
        Vector512<float> x1 = (ArrayLanes.Load(limits, 0) - ox) * px;
        Vector512<float> x2 = (ArrayLanes.Load(limits, Count) - ox) * px;
        Vector512<float> y1 = (ArrayLanes.Load(limits, 2 * Count) - oy) * py;
        Vector512<float> y2 = (ArrayLanes.Load(limits, 3 * Count) - oy) * py;
        Vector512<float> z1 = (ArrayLanes.Load(limits, 4 * Count) - oz) * pz;
        Vector512<float> z2 = (ArrayLanes.Load(limits, 5 * Count) - oz) * pz;
        Vector512<float> near = Vector512.MaxNative(
            Vector512.MaxNative(Vector512.MinNative(x1, x2), Vector512.MinNative(y1, y2)),
            Vector512.MaxNative(Vector512.MinNative(z1, z2), Vector512<float>.Zero));
        Vector512<float> far = Vector512.MinNative(
            Vector512.MinNative(Vector512.MaxNative(x1, x2), Vector512.MaxNative(y1, y2)),
            Vector512.MinNative(Vector512.MaxNative(z1, z2), Vector512.Create((float)ray.End + 1.0f)));
        return (uint)Vector512.LessThanOrEqual(near, far).ExtractMostSignificantBits();
    }

    /// <summary>The boxes that ways of a fan may meet, as bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public uint Meet(GroundFan fan)
    {
        (Vector512<float> near, Vector512<float> far) = (Vector512<float>.Zero, Vector512.Create(End));
        Cut(0, fan.End.X, fan.Limits, ref near, ref far);
        Cut(1, fan.End.Y, fan.Limits, ref near, ref far);
        Cut(2, fan.End.Z, fan.Limits, ref near, ref far);
        return (uint)Vector512.LessThanOrEqual(near, far).ExtractMostSignificantBits();
    }

    /// <summary>The ways of a fan that may meet a box, as bits; those that are not open too.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public ulong Meet(int box, GroundFan fan)
    {
        (float ex, float ey, float ez) = ((float)fan.End.X, (float)fan.End.Y, (float)fan.End.Z);
        Vector512<float> lowX = Vector512.Create(_limits[box] - ex);
        Vector512<float> highX = Vector512.Create(_limits[Count + box] - ex);
        Vector512<float> lowY = Vector512.Create(_limits[(2 * Count) + box] - ey);
        Vector512<float> highY = Vector512.Create(_limits[(3 * Count) + box] - ey);
        Vector512<float> lowZ = Vector512.Create(_limits[(4 * Count) + box] - ez);
        Vector512<float> highZ = Vector512.Create(_limits[(5 * Count) + box] - ez);
        ReadOnlySpan<float> inverses = fan.Inverses;
        ulong met = 0;
        for (int way = 0; way < Receivers.Size; way += Vector512<float>.Count)
        {
            Vector512<float> px = ArrayLanes.Load(inverses, way);
            Vector512<float> py = ArrayLanes.Load(inverses, Receivers.Size + way);
            Vector512<float> pz = ArrayLanes.Load(inverses, (2 * Receivers.Size) + way);
            (Vector512<float> x1, Vector512<float> x2) = (lowX * px, highX * px);
            (Vector512<float> y1, Vector512<float> y2) = (lowY * py, highY * py);
            (Vector512<float> z1, Vector512<float> z2) = (lowZ * pz, highZ * pz);
            Vector512<float> near = Vector512.MaxNative(
                Vector512.MaxNative(Vector512.MinNative(x1, x2), Vector512.MinNative(y1, y2)),
                Vector512.MaxNative(Vector512.MinNative(z1, z2), Vector512<float>.Zero));
            Vector512<float> far = Vector512.MinNative(
                Vector512.MinNative(Vector512.MaxNative(x1, x2), Vector512.MaxNative(y1, y2)),
                Vector512.MinNative(Vector512.MaxNative(z1, z2), Vector512.Create(End)));
            met |= (ulong)Vector512.LessThanOrEqual(near, far).ExtractMostSignificantBits() << way;
        }

        return met;
    }

    /// <summary>Shortens the parts of a fan in the boxes to those between two faces of each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Cut(int axis, double end, float[] inverses, ref Vector512<float> near, ref Vector512<float> far)
    {
        Vector512<float> low = ArrayLanes.Load(_limits, 2 * axis * Count) - Vector512.Create((float)end);
        Vector512<float> high = ArrayLanes.Load(_limits, ((2 * axis) + 1) * Count) - Vector512.Create((float)end);
        Vector512<float> one = Vector512.Create(inverses[2 * axis]);
        Vector512<float> other = Vector512.Create(inverses[(2 * axis) + 1]);
        near = Vector512.MaxNative(near, Vector512.MinNative(
            Vector512.MinNative(low * one, high * one), Vector512.MinNative(low * other, high * other)));
        far = Vector512.MinNative(far, Vector512.MaxNative(
            Vector512.MaxNative(low * one, high * one), Vector512.MaxNative(low * other, high * other)));
    }

    private void SetAxis(int box, int axis, double low, double high)
    {
        _limits[(2 * axis * Count) + box] = (float)(low - Margin - (RelativeMargin * Math.Abs(low)));
        _limits[(((2 * axis) + 1) * Count) + box] = (float)(high + Margin + (RelativeMargin * Math.Abs(high)));
    }
}
