using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>Sixteen numbers and sixteen bits.</summary>
internal static class LaneMasks
{
    private static readonly Vector512<int> Bits = Vector512.Create(
        1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);

    /// <summary>All bits of a lane where its bit is set, otherwise none.</summary>
    public static Vector512<float> Of(uint bits) => Vector512.Equals(Vector512.Create((int)bits) & Bits, Bits).AsSingle();

    /// <summary>The greatest of the numbers.</summary>
    public static float Max(Vector512<float> values)
    {
        Vector256<float> eight = Vector256.MaxNative(values.GetLower(), values.GetUpper());
        Vector128<float> four = Vector128.MaxNative(eight.GetLower(), eight.GetUpper());
        return Math.Max(Math.Max(four[0], four[1]), Math.Max(four[2], four[3]));
    }

    /// <summary>The least of the numbers.</summary>
    public static float Min(Vector512<float> values)
    {
        Vector256<float> eight = Vector256.MinNative(values.GetLower(), values.GetUpper());
        Vector128<float> four = Vector128.MinNative(eight.GetLower(), eight.GetUpper());
        return Math.Min(Math.Min(four[0], four[1]), Math.Min(four[2], four[3]));
    }
}
