using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Operations on all eight lanes of a vector of doubles.</summary>
internal static class Lanes
{
    /// <summary>The index of each lane: 0 to 7.</summary>
    public static Vector512<double> Numbers
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
    }

    /// <summary>All bits of the lanes whose bit is set, none of the others.</summary>
    public static Vector512<double> Mask(uint bits)
    {
        Vector512<long> places = Vector512.Create(1L, 2, 4, 8, 16, 32, 64, 128);
        return Vector512.Equals(Vector512.Create((long)bits) & places, places).AsDouble();
    }

    /// <summary>The minimum of the lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Min(Vector512<double> values)
    {
        Vector256<double> four = Vector256.MinNative(values.GetLower(), values.GetUpper());
        Vector128<double> two = Vector128.MinNative(four.GetLower(), four.GetUpper());
        return Math.Min(two[0], two[1]);
    }
}
