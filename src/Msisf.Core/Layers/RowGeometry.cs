using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Layers;

/// <summary>Directions and angles of a row's pixels, eight at a time.</summary>
internal static class RowGeometry
{
    private static readonly int Lanes = Vector512<double>.Count;

    /// <summary>A vector less multiples of a row's vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void FindRest(Vector3D whole, double[] factors, VectorRow vectors, int count, VectorRow rest)
    {
        for (int i = 0; i < count; i += Lanes)
        {
            (LaneVector.All(whole) - (LaneVector.Load(factors, i) * LaneVector.Load(vectors, i))).Store(rest, i);
        }
    }

    /// <summary>
    /// Angles between two rows of vectors in degrees, [0, 180]; within 1e-15 rad of Kahan's formula in <see cref="Vector3D"/>, three times
    /// as fast.
    /// </summary>
    /// <param name="sign">1, or -1 for the angles to the opposite of <paramref name="v"/>.</param>
    public static void FindAngles(VectorRow u, VectorRow v, double sign, int count, double[] degrees)
    {
        Span<double> cosines = stackalloc double[Block];
        for (int first = 0; first < count; first += Block)
        {
            int length = Math.Min(Block, count - first);
            FindSines(u, v, sign, first, length, degrees, cosines);
            for (int i = 0; i < length; i++)
            {
                degrees[first + i] = double.RadiansToDegrees(Trigonometry.Atan2(degrees[first + i], cosines[i]));
            }
        }
    }

    /// <summary>
    /// Angles between two rows of vectors in degrees, right to the last digits at 0 and 180 too (<see cref="Vector3D.AngleBetween(Vector3D,
    /// Vector3D)"/>).
    /// </summary>
    public static void FindExactAngles(VectorRow u, double[] uLengths, VectorRow v, double[] vLengths, int count, double[] degrees)
    {
        Span<double> sums = stackalloc double[Block];
        for (int first = 0; first < count; first += Block)
        {
            int length = Math.Min(Block, count - first);
            FindDifferences(u, uLengths, v, vLengths, first, length, degrees, sums);
            for (int i = 0; i < length; i++)
            {
                degrees[first + i] = double.RadiansToDegrees(2.0 * Trigonometry.Atan2(degrees[first + i], sums[i]));
            }
        }
    }

    /// <summary>Pixels whose angles are computed at once; a multiple of eight.</summary>
    private const int Block = 256;

    /// <summary>Lengths lie between 1e-12 (a camera of the narrowest field) and 1e20, so squares neither overflow nor vanish.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindSines(
        VectorRow u, VectorRow v, double sign, int first, int count, double[] sines, Span<double> cosines)
    {
        for (int i = 0; i < count; i += Lanes)
        {
            LaneVector a = LaneVector.Load(u, first + i);
            LaneVector b = Vector512.Create(sign) * LaneVector.Load(v, first + i);
            LaneVector cross = LaneVector.Cross(a, b);
            LaneVector.Store(Vector512.Sqrt(LaneVector.Dot(cross, cross)), sines, first + i);
            LaneVector.Dot(a, b).CopyTo(cosines[i..]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindDifferences(
        VectorRow u, double[] uLengths, VectorRow v, double[] vLengths, int first, int count, double[] differences, Span<double> sums)
    {
        for (int i = 0; i < count; i += Lanes)
        {
            LaneVector a = LaneVector.Load(vLengths, first + i) * LaneVector.Load(u, first + i);
            LaneVector b = LaneVector.Load(uLengths, first + i) * LaneVector.Load(v, first + i);
            LaneVector difference = a - b;
            LaneVector sum = a + b;
            LaneVector.Store(
                LaneHypot.Of(LaneHypot.Of(difference.X, difference.Y), difference.Z), differences, first + i);
            LaneHypot.Of(LaneHypot.Of(sum.X, sum.Y), sum.Z).CopyTo(sums[i..]);
        }
    }
}
