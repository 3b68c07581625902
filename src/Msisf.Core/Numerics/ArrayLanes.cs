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
    private const string Read = "Numbers are read beyond their array.";

    private const string Written = "Numbers are written beyond their array.";

    /// <summary>Reads numbers.</summary>
    /// <param name="values">All of them must be in it.</param>
    /// <param name="first">Index of the first one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<T> Load<T>(T[] values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector512<T>.Count), Read);
        return Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    /// <inheritdoc cref="Load{T}(T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<T> Load<T>(ReadOnlySpan<T> values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector512<T>.Count), Read);
        return Vector512.LoadUnsafe(ref MemoryMarshal.GetReference(values), (nuint)first);
    }

    /// <summary>Reads half as many numbers.</summary>
    /// <inheritdoc cref="Load{T}(T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<T> Load256<T>(T[] values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector256<T>.Count), Read);
        return Vector256.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    /// <inheritdoc cref="Load256{T}(T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<T> Load256<T>(ReadOnlySpan<T> values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector256<T>.Count), Read);
        return Vector256.LoadUnsafe(ref MemoryMarshal.GetReference(values), (nuint)first);
    }

    /// <summary>Reads a quarter as many numbers.</summary>
    /// <inheritdoc cref="Load{T}(T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<T> Load128<T>(ReadOnlySpan<T> values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector128<T>.Count), Read);
        return Vector128.LoadUnsafe(ref MemoryMarshal.GetReference(values), (nuint)first);
    }

    /// <summary>One element, to be read or written.</summary>
    /// <param name="values">It must be in it.</param>
    /// <param name="index">Its index.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref T At<T>(T[] values, int index)
    {
        Debug.Assert(AreIn(values.Length, index, 1), "An element lies beyond its array.");
        return ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(values), index);
    }

    /// <inheritdoc cref="At{T}(T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref readonly T At<T>(ReadOnlySpan<T> values, int index)
    {
        Debug.Assert(AreIn(values.Length, index, 1), "An element lies beyond its array.");
        return ref Unsafe.Add(ref MemoryMarshal.GetReference(values), index);
    }

    /// <summary>Writes numbers.</summary>
    /// <param name="numbers">The numbers.</param>
    /// <param name="values">It must have room for all of them.</param>
    /// <param name="first">Index of the first one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector512<T> numbers, T[] values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector512<T>.Count), Written);
        numbers.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    /// <inheritdoc cref="StoreTo{T}(Vector512{T}, T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector512<T> numbers, Span<T> values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector512<T>.Count), Written);
        numbers.StoreUnsafe(ref MemoryMarshal.GetReference(values), (nuint)first);
    }

    /// <inheritdoc cref="StoreTo{T}(Vector512{T}, T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector256<T> numbers, T[] values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector256<T>.Count), Written);
        numbers.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)first);
    }

    /// <inheritdoc cref="StoreTo{T}(Vector512{T}, T[], int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector256<T> numbers, Span<T> values, int first)
    {
        Debug.Assert(AreIn(values.Length, first, Vector256<T>.Count), Written);
        numbers.StoreUnsafe(ref MemoryMarshal.GetReference(values), (nuint)first);
    }

    private static bool AreIn(int length, int first, int count) => first >= 0 && first <= length - count;
}
