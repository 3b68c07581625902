using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>Sums and bounds over some samples of a pixel, which a mask with a bit for each names.</summary>
internal static class SampleSums
{
    private const int Lanes = SamplePattern.Lanes;

    /// <summary>The samples that show a facet.</summary>
    /// <param name="facets">The facet of the first sample; those of the others follow it, whole vectors.</param>
    /// <param name="vectors">Number of vectors.</param>
    /// <param name="facet">The facet.</param>
    public static ulong SamplesOf(ref int facets, int vectors, int facet)
    {
        ulong samples = 0;
        for (int vector = 0; vector < vectors; vector++)
        {
            ulong same = Vector256.Equals(Vector256.LoadUnsafe(ref facets, (nuint)(vector * Lanes)), Vector256.Create(facet))
                .ExtractMostSignificantBits();
            samples |= same << (vector * Lanes);
        }

        return samples;
    }

    /// <summary>Sums up the coordinates and inverse depths of some samples.</summary>
    public static (double X, double Y, double Inverse) Sum(ref double xs, ref double ys, ref double inverses, ulong samples)
    {
        Vector512<double> sumX = Vector512<double>.Zero;
        Vector512<double> sumY = Vector512<double>.Zero;
        Vector512<double> sumInverse = Vector512<double>.Zero;
        for (nuint sample = 0; samples != 0; samples >>= Lanes, sample += Lanes)
        {
            Vector512<double> isMeant = MaskOf(samples);
            sumX += isMeant & Vector512.LoadUnsafe(ref xs, sample);
            sumY += isMeant & Vector512.LoadUnsafe(ref ys, sample);
            sumInverse += isMeant & Vector512.LoadUnsafe(ref inverses, sample);
        }

        return (Sum(sumX), Sum(sumY), Sum(sumInverse));
    }

    /// <summary>px: distance along columns or rows of the farthest of some samples from a place.</summary>
    public static float ReachOf(ulong samples, double right, double down, SamplePattern pattern)
    {
        Vector512<double> reach = Vector512<double>.Zero;
        for (nuint sample = 0; samples != 0; samples >>= Lanes, sample += Lanes)
        {
            reach = Vector512.MaxNative(reach, MaskOf(samples) & Vector512.MaxNative(
                Vector512.Abs(Vector512.LoadUnsafe(ref pattern.Right[0], sample) - Vector512.Create(right)),
                Vector512.Abs(Vector512.LoadUnsafe(ref pattern.Down[0], sample) - Vector512.Create(down))));
        }

        Vector256<double> four = Vector256.MaxNative(reach.GetLower(), reach.GetUpper());
        Vector128<double> two = Vector128.MaxNative(four.GetLower(), four.GetUpper());
        return (float)Math.Max(two[0], two[1]);
    }

    /// <summary>Mask of the lanes whose bits are set in the lowest byte.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> MaskOf(ulong bits) => Vector512.Equals(
        Vector512.Create((long)(bits & 0xff)) & Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L),
        Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L)).AsDouble();

    /// <summary>The sum of eight numbers, in an order that does not depend on the processor.</summary>
    private static double Sum(Vector512<double> numbers)
    {
        Vector256<double> four = numbers.GetLower() + numbers.GetUpper();
        Vector128<double> two = four.GetLower() + four.GetUpper();
        return two[0] + two[1];
    }
}
