using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// By how much invented rays change the reflectance of the ground that a view shows: factors at the samples of lattices twice as wide as
/// those of its windows, and between them linear. Safe for several threads.
/// </summary>
/// <param name="places">Where the windows lie, the coarsest first; at least one.</param>
internal sealed class GroundBrightness(DetailTiles<float> tiles, IReadOnlyList<WindowPlace> places) : IGroundBrightness
{
    /// <summary>Places whose map coordinates are computed at once.</summary>
    private const int Block = 64;

    private readonly PolarStereographic _metres = places[0].Face.Map(0);
    private readonly BrightnessWindow[] _windows = [.. places.Select(place => new BrightnessWindow(tiles, place))];

    /// <inheritdoc/>
    /// <remarks>Beyond the windows reflectances stay.</remarks>
    public void Scale(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, Span<double> reflectances)
    {
        Span<double> lines = stackalloc double[Block];
        Span<double> samples = stackalloc double[Block];
        int window = 0;
        for (int first = 0; first < reflectances.Length; first += Block)
        {
            int count = Math.Min(Block, reflectances.Length - first);
            FindPlaces(x.Slice(first, count), y.Slice(first, count), z.Slice(first, count), lines, samples);
            for (int i = 0; i < count; i++)
            {
                reflectances[first + i] *= FactorAt(lines[i], samples[i], ref window);
            }
        }
    }

    private double FactorAt(double line, double sample, ref int window)
    {
        while (!_windows[window].Holds(line, sample))
        {
            if (window-- == 0)
            {
                window = 0;
                return 1.0;
            }
        }

        while (window + 1 < _windows.Length && _windows[window + 1].Holds(line, sample))
        {
            window++;
        }

        double factor = _windows[window].FactorAt(line, sample);
        return window == 0 ? 1.0 + (_windows[0].PartAt(line, sample) * (factor - 1.0)) : factor;
    }

    /// <summary>Lines and samples of the map of metres: <see cref="PolarStereographic.PixelOf"/> of places at any radius.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private void FindPlaces(
        ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, Span<double> lines, Span<double> samples)
    {
        int turn = _metres.Turn;
        ReadOnlySpan<double> a = turn == 0 ? x : turn == 1 ? y : z;
        ReadOnlySpan<double> b = turn == 0 ? y : turn == 1 ? z : x;
        ReadOnlySpan<double> c = turn == 0 ? z : turn == 1 ? x : y;
        for (int i = 0; i < x.Length; i += Vector512<double>.Count)
        {
            Vector512<double> across = Load(a, i);
            Vector512<double> along = Load(b, i);
            Vector512<double> up = Load(c, i);
            Vector512<double> length = Vector512.Sqrt((across * across) + (along * along) + (up * up));
            Vector512<double> scale = Vector512.Create(2.0 * MoonConstants.ReferenceRadius) / (length + (_metres.PoleSign * up));
            (across * scale * _metres.PoleSign).CopyTo(lines[i..]);
            (along * scale).CopyTo(samples[i..]);
        }
    }

    private static Vector512<double> Load(ReadOnlySpan<double> values, int first)
    {
        if (first + Vector512<double>.Count <= values.Length)
        {
            return Vector512.Create(values[first..]);
        }

        Span<double> last = stackalloc double[Vector512<double>.Count];
        last.Fill(values[^1]);
        values[first..].CopyTo(last);
        return Vector512.Create((ReadOnlySpan<double>)last);
    }
}
