using Msisf.Adapters.Drawing;
using Msisf.Core.Maps;

namespace Msisf.Adapters.Illumination;

/// <summary>Draws a map with its legend and a scale bar.</summary>
public static class LightMapPicture
{
    /// <summary>px: the longer side of a map at most; each of its pixels is then a cell of several.</summary>
    private const int LongestSide = 1024;

    /// <summary>px: at least.</summary>
    private const int ShortestSide = 320;

    /// <summary>px under the map.</summary>
    private const int Foot = 56;

    private const int LegendWidth = 160;
    private const double FontSize = 12.0;

    /// <summary>Five colours from the least to the greatest value, dark to light for all kinds of sight.</summary>
    private static readonly (double Red, double Green, double Blue)[] Colors =
        [(0.0, 0.0, 0.08), (0.25, 0.1, 0.4), (0.7, 0.2, 0.35), (0.98, 0.55, 0.2), (1.0, 1.0, 0.75)];

    /// <summary>Writes a PNG.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="grid">Where its cells lie.</param>
    /// <exception cref="Core.Errors.ExternalPartException">Skia is missing.</exception>
    public static void Write(Stream stream, LightMap map, MapGrid grid)
    {
        int longest = Math.Max(grid.Lines, grid.Samples);
        double scale = longest > LongestSide ? (double)LongestSide / longest : Math.Max(1, ShortestSide / longest);
        int width = Math.Max(LegendWidth * 2, (int)Math.Ceiling(grid.Samples * scale));
        int height = (int)Math.Ceiling(grid.Lines * scale);
        float[] known = [.. map.Values.Where(float.IsFinite)];
        (float least, float most) = known.Length == 0 ? (0.0f, 0.0f) : (known.Min(), known.Max());
        using Canvas image = Canvas.Black(width, height + Foot);
        image.SetColor(0.5, 0.5, 0.5, 1.0); // cells without data, and beside a narrow map, where black would look like a dark place
        image.FillRectangle(0.0, 0.0, width, height);
        for (int y = 0; y < height; y++)
        {
            int line = Math.Min(grid.Lines - 1, (int)(y / scale));
            for (int x = 0; x < (int)Math.Ceiling(grid.Samples * scale);)
            {
                int sample = Math.Min(grid.Samples - 1, (int)(x / scale));
                int next = Math.Max(x + 1, (int)Math.Ceiling((sample + 1) * scale));
                if (map.Values[(line * grid.Samples) + sample] is var value && float.IsFinite(value))
                {
                    SetColor(image, most > least ? (value - least) / (most - least) : 0.0);
                    image.FillRectangle(x, y, next - x, 1.0);
                }

                x = next;
            }
        }

        for (int x = 0; x < LegendWidth; x++)
        {
            SetColor(image, x / (LegendWidth - 1.0));
            image.FillRectangle(x + 4, height + 6, 1.0, 12.0);
        }

        image.SetColor(1.0, 1.0, 1.0, 1.0);
        string range = known.Length == 0 ? "no data" : Invariant($"{least:G4} to {most:G4} {map.Unit}");
        image.DrawText(range, 4.0, height + 34.0, FontSize);
        double cell = grid.SizeOf(grid.Lines / 2, grid.Samples / 2).Width;
        double bar = NiceLength(0.4 * width / scale * cell);
        double right = width - 8.0;
        image.DrawLine(right - (bar / cell * scale), height + 12.0, right, height + 12.0, 3.0);
        string text = bar >= 1000.0
            ? string.Create(CultureInfo.InvariantCulture, $"{bar / 1000.0:R} km")
            : string.Create(CultureInfo.InvariantCulture, $"{bar:R} m");
        image.DrawText(text, right - image.MeasureText(text, FontSize), height + 34.0, FontSize);
        image.DrawText(map.Name, 4.0, height + 50.0, FontSize);
        image.WritePng(stream);
    }

    private static void SetColor(Canvas image, double part)
    {
        double place = Math.Clamp(part, 0.0, 1.0) * (Colors.Length - 1);
        int index = Math.Min(Colors.Length - 2, (int)place);
        double rest = place - index;
        (double Red, double Green, double Blue) a = Colors[index];
        (double Red, double Green, double Blue) b = Colors[index + 1];
        image.SetColor(
            a.Red + (rest * (b.Red - a.Red)), a.Green + (rest * (b.Green - a.Green)), a.Blue + (rest * (b.Blue - a.Blue)), 1.0);
    }

    /// <summary>1, 2 or 5 times a power of ten, no longer than a length.</summary>
    private static double NiceLength(double most)
    {
        double power = Math.Pow(10.0, Math.Floor(Math.Log10(most)));
        return most >= 5.0 * power ? 5.0 * power : most >= 2.0 * power ? 2.0 * power : power;
    }
}
