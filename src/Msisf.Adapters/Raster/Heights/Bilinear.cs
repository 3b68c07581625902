using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>The two rows or columns between which a place lies.</summary>
/// <param name="First">The first of them, counted in the box that is read; 0 of a place beside the map.</param>
/// <param name="Part">How far it lies behind that: 0 on it, below 1; NaN of a place beside the map.</param>
internal readonly record struct PixelNeighbours(int First, double Part)
{
    /// <summary>px: a place so far beside a border lies on it; GDAL's pixels are as wide as labels round them.</summary>
    private const double OnBorder = 0.05;

    /// <summary>1: a part below is rounding; the place is that of a pixel.</summary>
    private const double OnPixel = 1e-9;

    /// <summary>The one behind; of a place on the first that one.</summary>
    public int Second => Part > 0.0 ? First + 1 : First;

    public static PixelNeighbours Of(double place, int origin, int size, bool isRing)
    {
        if (!(place >= -0.5 - OnBorder && place <= size - 0.5 + OnBorder) && !(isRing && double.IsFinite(place)))
        {
            return new PixelNeighbours(0, double.NaN);
        }

        place = isRing ? place : Math.Clamp(place, 0.0, size - 1.0);
        double first = Math.Floor(place);
        double part = place - first;
        return part > 1.0 - OnPixel
            ? new PixelNeighbours((int)first + 1 - origin, 0.0)
            : new PixelNeighbours((int)first - origin, part < OnPixel ? 0.0 : part);
    }
}

/// <summary>Values between pixels.</summary>
internal static class Bilinear
{
    /// <summary>The values of places in a row, four at a time where there are as many.</summary>
    /// <param name="upper">The row of pixels above the places.</param>
    /// <param name="lower">The one below them.</param>
    /// <param name="down">How far the places lie below the first.</param>
    /// <param name="left">The pixels before the places.</param>
    /// <param name="right">Those behind them.</param>
    /// <param name="across">How far the places lie behind the pixels before them; NaN beside the map.</param>
    public static void Blend(
        Span<float> values, ReadOnlySpan<float> upper, ReadOnlySpan<float> lower, double down, ReadOnlySpan<int> left,
        ReadOnlySpan<int> right, ReadOnlySpan<double> across)
    {
        int i = 0;
        for (; i <= values.Length - 4; i += 4)
        {
            ReadOnlySpan<int> before = left.Slice(i, 4);
            ReadOnlySpan<int> behind = right.Slice(i, 4);
            Vector256<double> part = Vector256.Create(across.Slice(i, 4));
            Vector256<double> value = Along(upper, before, behind, part);
            value = down == 0.0 ? value : value + (down * (Along(lower, before, behind, part) - value));
            Vector128.Narrow(value.GetLower(), value.GetUpper()).CopyTo(values[i..]);
        }

        for (; i < values.Length; i++)
        {
            double value = Along(upper, left[i], right[i], across[i]);
            values[i] = (float)(down == 0.0 ? value
                : value + (down * (Along(lower, left[i], right[i], across[i]) - value)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Along(
        ReadOnlySpan<float> pixels, ReadOnlySpan<int> left, ReadOnlySpan<int> right, Vector256<double> part)
    {
        Vector256<double> before = Four(pixels, left);
        return Vector256.ConditionalSelect(
            Vector256.Equals(part, Vector256<double>.Zero), before, before + (part * (Four(pixels, right) - before)));
    }

    private static double Along(ReadOnlySpan<float> pixels, int left, int right, double part) =>
        part == 0.0 ? pixels[left] : pixels[left] + (part * (pixels[right] - (double)pixels[left]));

    /// <summary>Four pixels, which mostly lie side by side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Four(ReadOnlySpan<float> pixels, ReadOnlySpan<int> columns)
    {
        Vector128<float> four = columns[3] - columns[0] == 3 && columns[1] - columns[0] == 1 && columns[2] - columns[1] == 1
            ? Vector128.Create(pixels.Slice(columns[0], 4))
            : Vector128.Create(pixels[columns[0]], pixels[columns[1]], pixels[columns[2]], pixels[columns[3]]);
        return Vector256.Create(Vector128.WidenLower(four), Vector128.WidenUpper(four));
    }
}
