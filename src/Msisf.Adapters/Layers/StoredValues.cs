using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>Turns computed values into the numbers that a file holds.</summary>
internal static class StoredValues
{
    /// <summary>Rounds values to single precision; NaN stays.</summary>
    /// <param name="layer">Directions that are rounded up to 360 degrees become 0.</param>
    /// <param name="values">Real numbers or NaN.</param>
    /// <param name="stored">As many.</param>
    public static void Round(Layer layer, ReadOnlySpan<double> values, Span<float> stored)
    {
        Narrow(values, stored);
        if (layer.IsDirection)
        {
            stored.Replace(360.0f, 0.0f);
        }
    }

    /// <summary>Converts values; what is undefined becomes <see cref="Layer.UndefinedNumber"/>.</summary>
    /// <typeparam name="T">byte (every value is defined) or int.</typeparam>
    /// <param name="values">Whole numbers or NaN.</param>
    /// <param name="stored">As many.</param>
    public static void Convert<T>(ReadOnlySpan<double> values, Span<T> stored)
        where T : unmanaged, INumberBase<T>
    {
        for (int i = 0; i < values.Length; i++)
        {
            stored[i] = double.IsNaN(values[i]) ? T.CreateChecked(Layer.UndefinedNumber) : T.CreateChecked(values[i]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // else the first rows would be converted with unoptimised vectors
    private static void Narrow(ReadOnlySpan<double> values, Span<float> stored)
    {
        int i = 0;
        for (; i <= values.Length - Vector256<float>.Count; i += Vector256<float>.Count)
        {
            Vector256.Narrow(Vector256.Create(values[i..]), Vector256.Create(values[(i + Vector256<double>.Count)..])).CopyTo(stored[i..]);
        }

        for (; i < values.Length; i++)
        {
            stored[i] = (float)values[i];
        }
    }
}
