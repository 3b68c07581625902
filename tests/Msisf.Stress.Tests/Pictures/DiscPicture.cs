namespace Msisf.Stress.Tests.Pictures;

/// <summary>A bright disc on black, with the exact grey of each pixel to 1/64.</summary>
internal static class DiscPicture
{
    public const int Side = 100; // px
    private const int SamplesAcross = 8;

    /// <summary>Draws it.</summary>
    /// <param name="centreX">px from the left edge of pixel 0.</param>
    /// <param name="radius">px.</param>
    /// <param name="brightness">Inside, by x.</param>
    public static double[,] Draw(double centreX, double radius, Func<int, double>? brightness = null)
    {
        double[,] picture = new double[Side, Side];
        for (int y = 0; y < Side; y++)
        {
            for (int x = 0; x < Side; x++)
            {
                int inside = 0;
                for (int sample = 0; sample < SamplesAcross * SamplesAcross; sample++)
                {
                    double dx = x + ((sample % SamplesAcross + 0.5) / SamplesAcross) - centreX;
                    double dy = y + ((sample / SamplesAcross + 0.5) / SamplesAcross) - (Side / 2);
                    inside += (dx * dx) + (dy * dy) <= radius * radius ? 1 : 0;
                }

                picture[y, x] = (brightness?.Invoke(x) ?? 1.0) * inside / (SamplesAcross * SamplesAcross);
            }
        }

        return picture;
    }
}
