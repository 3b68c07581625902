using Msisf.Adapters.Render;

namespace Msisf.App.Twins;

/// <summary>Pictures of an image of numbers for a page, as PNG in the text of the page; long strips lie on their side.</summary>
internal sealed class TwinPicture
{
    /// <summary>px: longer pictures are reduced.</summary>
    private const int Longest = 1200;

    /// <summary>An image so many times as high as wide lies on its side.</summary>
    private const int OfStrip = 2;

    private readonly int _samples;
    private readonly int[] _lines;
    private readonly int _step;

    /// <summary>Takes the form of an image.</summary>
    /// <param name="pixels">Lines in which it has no number are left out.</param>
    /// <param name="samples">px: its width.</param>
    public TwinPicture(float[] pixels, int samples)
    {
        _samples = samples;
        _lines = [.. Enumerable.Range(0, pixels.Length / samples)
            .Where(line => Array.Exists(pixels[(line * samples)..((line + 1) * samples)], float.IsFinite))];
        _step = Math.Max(1, (Math.Max(samples, _lines.Length) + Longest - 1) / Longest);
        LiesOnSide = _lines.Length > OfStrip * samples;
    }

    /// <summary>Whether lines run from left to right, and samples downwards.</summary>
    public bool LiesOnSide { get; }

    private int Samples => (_samples + _step - 1) / _step;

    private int Lines => (_lines.Length + _step - 1) / _step;

    /// <summary>An element img.</summary>
    /// <param name="pixels">The numbers; NaN is drawn in a colour of its own.</param>
    /// <param name="low">What is black, or blue.</param>
    /// <param name="high">What is white, or red.</param>
    /// <param name="isTwoSided">From blue by white to red in place of grey.</param>
    /// <param name="text">What the picture shows, without markup.</param>
    public string Element(float[] pixels, double low, double high, bool isTwoSided, string text)
    {
        (int width, int height) = LiesOnSide ? (Lines, Samples) : (Samples, Lines);
        ushort[] colors = new ushort[3 * width * height];
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                double mean = LiesOnSide ? MeanOf(pixels, y, x) : MeanOf(pixels, x, y);
                (ushort red, ushort green, ushort blue) = ColorOf((mean - low) / (high - low), isTwoSided);
                int at = 3 * ((y * width) + x);
                (colors[at], colors[at + 1], colors[at + 2]) = (red, green, blue);
            }
        }

        using MemoryStream png = new();
        PngWriter.WriteColors(png, colors, width);
        int scale = Math.Max(1, Longest / Math.Max(width, height));
        return Invariant(
            $"<img width=\"{scale * width}\" height=\"{scale * height}\" alt=\"{text}\" src=\"data:image/png;base64,"
                + $"{Convert.ToBase64String(png.ToArray())}\">");
    }

    /// <summary>What is drawn white: the number below which 99.5 % of the numbers lie; 1 if there are none.</summary>
    public static double WhiteOf(float[] pixels)
    {
        float[] sorted = [.. pixels.Where(float.IsFinite)];
        Array.Sort(sorted);
        return sorted.Length == 0 ? 1.0 : sorted[(int)(0.995 * (sorted.Length - 1))];
    }

    private double MeanOf(float[] pixels, int x, int y)
    {
        (double sum, int count) = (0.0, 0);
        for (int line = y * _step; line < Math.Min(_lines.Length, (y + 1) * _step); line++)
        {
            for (int sample = x * _step; sample < Math.Min(_samples, (x + 1) * _step); sample++)
            {
                float pixel = pixels[(_lines[line] * _samples) + sample];
                if (float.IsFinite(pixel))
                {
                    sum += pixel;
                    count++;
                }
            }
        }

        return sum / count;
    }

    private static (ushort Red, ushort Green, ushort Blue) ColorOf(double level, bool isTwoSided)
    {
        if (double.IsNaN(level))
        {
            return (Sixteen(0.35), Sixteen(0.45), Sixteen(0.35));
        }

        double part = Math.Clamp(level, 0.0, 1.0);
        return !isTwoSided ? (Sixteen(part), Sixteen(part), Sixteen(part))
            : part < 0.5 ? (Sixteen(2.0 * part), Sixteen(2.0 * part), ushort.MaxValue)
            : (ushort.MaxValue, Sixteen(2.0 - (2.0 * part)), Sixteen(2.0 - (2.0 * part)));
    }

    private static ushort Sixteen(double part) => (ushort)Math.Round(part * ushort.MaxValue);
}
