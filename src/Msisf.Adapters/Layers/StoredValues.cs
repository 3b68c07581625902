using System.Numerics;
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
        for (int i = 0; i < values.Length; i++)
        {
            stored[i] = (float)values[i];
        }

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
}
