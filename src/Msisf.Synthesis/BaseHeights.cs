using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The heights of the base model, prepared for interpolation. Towards the poles a model's samples are very close together along the
/// parallels: a pixel may be 8 km long and a few metres wide, and interpolating such pixels gives stripes that run to the pole. So beyond
/// 70 degrees of latitude the heights are smoothed along the parallel; from 80 degrees on, the smoothing is as wide as a pixel is along
/// the meridian.
/// </summary>
internal sealed class BaseHeights
{
    private const double HonouredDegrees = 70.0;
    private const double FadeDegrees = 6.0; // from here on the detail is left as it is
    private const double FullySmoothedDegrees = 80.0;
    private const double CosineOfHonoured = 0.34202014332566873;

    private readonly IGlobalGrid _model;
    private readonly int _lines;
    private readonly int _around;

    /// <summary>Wraps a model.</summary>
    public BaseHeights(IGlobalGrid model)
    {
        _model = model;
        _lines = 180 * model.PixelsPerDegree;
        _around = 360 * model.PixelsPerDegree;
    }

    /// <summary>Samples a degree.</summary>
    public int PixelsPerDegree => _model.PixelsPerDegree;

    /// <summary>Heights of consecutive pixels of one line.</summary>
    /// <param name="line">May be below 0 or above the last line: beyond a pole the lines continue along the opposite meridian.</param>
    /// <param name="pixel">First pixel, any number; the pixels continue across the prime meridian.</param>
    /// <param name="heights">Filled with m over the reference radius; at most one whole line.</param>
    public void ReadHeights(int line, int pixel, Span<double> heights)
    {
        if (line < 0 || line >= _lines)
        {
            line = line < 0 ? -1 - line : (2 * _lines) - 1 - line;
            pixel += _around / 2;
        }

        pixel = ((pixel % _around) + _around) % _around;
        int halfWidth = HalfWidth(line);
        if (halfWidth > 1)
        {
            ReadSmoothed(line, pixel, halfWidth, heights);
            return;
        }

        _model.ReadRadii(line, pixel, heights);
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] -= MoonConstants.ReferenceRadius;
        }
    }

    /// <summary>
    /// Weight, 0 to 1, with which the mean of the detail is subtracted on a line: 1 keeps the pixels' means, 0 adds the detail unchanged.
    /// </summary>
    public double HonouredPart(int line) =>
        Math.Clamp(1.0 - ((Math.Abs(LatitudeDegrees(line)) - HonouredDegrees) / FadeDegrees), 0.0, 1.0);

    // Latitudes beyond a pole are folded back: 90.1 degrees is as far from the equator as 89.9.
    private double LatitudeDegrees(int line)
    {
        double latitude = 90.0 - ((line + 0.5) / PixelsPerDegree);
        return Math.Abs(latitude) > 90.0 ? 180.0 - Math.Abs(latitude) : latitude;
    }

    private int HalfWidth(int line)
    {
        double latitude = Math.Abs(LatitudeDegrees(line));
        double part = Math.Clamp((latitude - HonouredDegrees) / (FullySmoothedDegrees - HonouredDegrees), 0.0, 1.0);
        double width = (CosineOfHonoured + (part * (1.0 - CosineOfHonoured))) / PortableMath.SinCosDegrees(latitude).Cos;
        return latitude <= HonouredDegrees ? 1 : Math.Clamp((int)width, 1, _around / 4);
    }

    // Two running means in succession give triangular weights. The sums always begin at longitude 0, so that they have the same bits for
    // every tile.
    private void ReadSmoothed(int line, int pixel, int halfWidth, Span<double> heights)
    {
        double[] row = new double[_around];
        double[] first = new double[_around];
        _model.ReadRadii(line, 0, row);
        RunningMean(row, first, halfWidth);
        RunningMean(first, row, halfWidth);
        for (int i = 0; i < heights.Length; i++)
        {
            // Each of the two means is shifted by half its width.
            int centred = pixel + i - (halfWidth - 1);
            heights[i] = row[((centred % _around) + _around) % _around] - MoonConstants.ReferenceRadius;
        }
    }

    private static void RunningMean(double[] source, double[] target, int width)
    {
        double sum = 0.0;
        for (int i = 0; i < width; i++)
        {
            sum += source[i];
        }

        for (int i = 0; i < source.Length; i++)
        {
            target[i] = sum / width;
            sum += source[(i + width) % source.Length] - source[i];
        }
    }
}
