using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>Eight points, and the lines from them to the viewer, m.</summary>
internal readonly struct SightLanes
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SightLanes(Vector3D eye, Vector512<double> x, Vector512<double> y, Vector512<double> z)
    {
        X = x;
        Y = y;
        Z = z;
        ToEyeX = Vector512.Create(eye.X) - x;
        ToEyeY = Vector512.Create(eye.Y) - y;
        ToEyeZ = Vector512.Create(eye.Z) - z;
        AxisSquared = Vector512.MaxNative((x * x) + (y * y), Vector512<double>.One);
        RangeSquared = (ToEyeX * ToEyeX) + (ToEyeY * ToEyeY) + (ToEyeZ * ToEyeZ);
    }

    public Vector512<double> X { get; }

    public Vector512<double> Y { get; }

    public Vector512<double> Z { get; }

    public Vector512<double> ToEyeX { get; }

    public Vector512<double> ToEyeY { get; }

    public Vector512<double> ToEyeZ { get; }

    /// <summary>Square of the distance from the polar axis; 1 m from the axis is on it.</summary>
    public Vector512<double> AxisSquared { get; }

    /// <summary>Square of the distance from the viewer.</summary>
    public Vector512<double> RangeSquared { get; }
}
