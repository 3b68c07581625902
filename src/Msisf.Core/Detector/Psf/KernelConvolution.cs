using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Psf;

/// <summary>Spreads the light of an image by a kernel. The sums have a fixed order, so the result does not depend on threads.</summary>
internal static class KernelConvolution
{
    private const int Lanes = 4;
    private const int Columns = 8 * Lanes; // columns that are summed at once: their sums stay in registers

    /// <summary>Computes one row.</summary>
    /// <param name="source">An image that is wider and higher than the result by the kernel's radius on each side; by rows.</param>
    /// <param name="sourceWidth">px.</param>
    /// <param name="row">Row of the result, from 0.</param>
    /// <param name="target">Receives the row: <paramref name="sourceWidth"/> minus twice the radius.</param>
    public static void Row(ReadOnlySpan<double> source, int sourceWidth, PointSpreadKernel kernel, int row, Span<double> target)
    {
        // Light goes from each point to its surroundings, so the kernel's first weight meets the last pixel of the window.
        int column = 0;
        for (; column <= target.Length - Columns; column += Columns)
        {
            Wide(source, sourceWidth, kernel, (row * sourceWidth) + column, target[column..]);
        }

        for (; column <= target.Length - Lanes; column += Lanes)
        {
            Narrow(source, sourceWidth, kernel, (row * sourceWidth) + column, target[column..]);
        }

        for (; column < target.Length; column++)
        {
            target[column] = Single(source, sourceWidth, kernel, (row * sourceWidth) + column);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be spread with unoptimised vectors
    private static void Wide(ReadOnlySpan<double> source, int width, PointSpreadKernel kernel, int start, Span<double> target)
    {
        Vector256<double> s0 = Vector256<double>.Zero, s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0, s6 = s0, s7 = s0;
        int size = kernel.Size;
        for (int y = 0; y < size; y++)
        {
            ReadOnlySpan<double> weights = kernel.Weights.Slice((size - 1 - y) * size, size);
            ref double line = ref MemoryMarshal.GetReference(source.Slice(start + (y * width), size - 1 + Columns));
            for (int x = 0; x < weights.Length; x++)
            {
                Vector256<double> weight = Vector256.Create(weights[weights.Length - 1 - x]);
                ref double values = ref Unsafe.Add(ref line, x);
                s0 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values), s0);
                s1 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, Lanes), s1);
                s2 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 2 * Lanes), s2);
                s3 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 3 * Lanes), s3);
                s4 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 4 * Lanes), s4);
                s5 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 5 * Lanes), s5);
                s6 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 6 * Lanes), s6);
                s7 = Vector256.FusedMultiplyAdd(weight, Vector256.LoadUnsafe(ref values, 7 * Lanes), s7);
            }
        }

        s0.CopyTo(target);
        s1.CopyTo(target[Lanes..]);
        s2.CopyTo(target[(2 * Lanes)..]);
        s3.CopyTo(target[(3 * Lanes)..]);
        s4.CopyTo(target[(4 * Lanes)..]);
        s5.CopyTo(target[(5 * Lanes)..]);
        s6.CopyTo(target[(6 * Lanes)..]);
        s7.CopyTo(target[(7 * Lanes)..]);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Narrow(ReadOnlySpan<double> source, int width, PointSpreadKernel kernel, int start, Span<double> target)
    {
        Vector256<double> sum = Vector256<double>.Zero;
        int size = kernel.Size;
        for (int y = 0; y < size; y++)
        {
            ReadOnlySpan<double> weights = kernel.Weights.Slice((size - 1 - y) * size, size);
            ReadOnlySpan<double> line = source[(start + (y * width))..];
            for (int x = 0; x < size; x++)
            {
                sum = Vector256.FusedMultiplyAdd(Vector256.Create(weights[size - 1 - x]), Vector256.Create(line.Slice(x, Lanes)), sum);
            }
        }

        sum.CopyTo(target);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static double Single(ReadOnlySpan<double> source, int width, PointSpreadKernel kernel, int start)
    {
        double sum = 0.0;
        int size = kernel.Size;
        for (int y = 0; y < size; y++)
        {
            for (int x = 0; x < size; x++)
            {
                sum = Math.FusedMultiplyAdd(
                    kernel.Weights[((size - 1 - y) * size) + size - 1 - x], source[start + (y * width) + x], sum);
            }
        }

        return sum;
    }
}
