using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>
/// Reads and writes as many numbers of an array at once as a vector holds. Only debug builds, which the tests use, check that the array
/// holds all of them: what lies behind an array is any number, also NaN.
/// </summary>
internal static class ArrayLanes
{
    /// <summary>Reads numbers.</summary>
    /// <param name="values">All of them must be in it.</param>
    /// <param name="first">Index of the first one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<T> Load<T>(T[] values, int first)
    {
        Debug.Assert(AreIn(values, first, Vector512<T>.Count), "A vector is read beyond its array.");
        return Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    /// <summary>Writes numbers.</summary>
    /// <param name="numbers">The numbers.</param>
    /// <param name="values">It must have room for all of them.</param>
    /// <param name="first">Index of the first one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector512<T> numbers, T[] values, int first)
    {
        Debug.Assert(AreIn(values, first, Vector512<T>.Count), "A vector is written beyond its array.");
        numbers.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    private static bool AreIn<T>(T[] values, int first, int count) => first >= 0 && first <= values.Length - count;
}
