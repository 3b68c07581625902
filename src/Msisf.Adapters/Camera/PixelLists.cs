using Msisf.Adapters.Input;

namespace Msisf.Adapters.Camera;

/// <summary>Reads lists of pixels from a camera file.</summary>
internal static class PixelLists
{
    private const int MaxNumbers = 300_000;

    /// <summary>Reads a list: column and row of each pixel, from 1, and what else belongs to it.</summary>
    /// <param name="numbersPerPixel">2, or more if a pixel has other numbers.</param>
    /// <param name="geometry">The image's size.</param>
    /// <returns>The numbers of each pixel; empty if the key is not there.</returns>
    public static IReadOnlyList<double[]> Read(SettingsSection section, string key, int numbersPerPixel, DetectorGeometry geometry)
    {
        double[] numbers = section.Numbers(key, numbersPerPixel, MaxNumbers) ?? [];
        if (numbers.Length % numbersPerPixel != 0)
        {
            throw section.Wrong(key, $"'{key}' has {numbers.Length} numbers; {numbersPerPixel} of each pixel are needed");
        }

        double[][] pixels = [.. numbers.Chunk(numbersPerPixel)];
        foreach (double[] pixel in pixels)
        {
            if (!IsIn(pixel[0], geometry.Width) || !IsIn(pixel[1], geometry.Height))
            {
                string pair = FormattableString.Invariant($"({pixel[0]}, {pixel[1]})");
                throw section.Wrong(
                    key, $"'{key}' names pixel {pair}; columns go from 1 to {geometry.Width}, rows from 1 to {geometry.Height}");
            }
        }

        return pixels;
    }

    private static bool IsIn(double number, int max) => number >= 1.0 && number <= max && number == Math.Floor(number);
}
