namespace Msisf.Stress.Tests.Images;

/// <summary>A bright disc on black, with the exact grey of each pixel to 1/64.</summary>
internal static class DiscImage
{
    public const int Side = 100; // px
    private const int SubsamplesPerAxis = 8;

    /// <summary>Draws it.</summary>
    /// <param name="centreX">px from the left edge of pixel 0.</param>
    /// <param name="radius">px.</param>
    /// <param name="brightness">Inside, by x.</param>
    public static double[,] Draw(double centreX, double radius, Func<int, double>? brightness = null)
    {
        double[,] image = new double[Side, Side];
        for (int y = 0; y < Side; y++)
        {
            for (int x = 0; x < Side; x++)
            {
                int inside = 0;
                for (int sample = 0; sample < SubsamplesPerAxis * SubsamplesPerAxis; sample++)
                {
                    double dx = x + ((sample % SubsamplesPerAxis + 0.5) / SubsamplesPerAxis) - centreX;
                    double dy = y + ((sample / SubsamplesPerAxis + 0.5) / SubsamplesPerAxis) - (Side / 2);
                    inside += (dx * dx) + (dy * dy) <= radius * radius ? 1 : 0;
                }

                image[y, x] = (brightness?.Invoke(x) ?? 1.0) * inside / (SubsamplesPerAxis * SubsamplesPerAxis);
            }
        }

        return image;
    }
}
