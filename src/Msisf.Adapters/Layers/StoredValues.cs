using System.Numerics;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>Turns computed values into the whole numbers that a file holds.</summary>
internal static class StoredValues
{
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
}
