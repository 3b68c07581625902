namespace Msisf.Core.Camera;

/// <summary>Some neighbouring rows of an image.</summary>
/// <param name="First">0: the topmost row of the image.</param>
/// <param name="End">One past the lowest row.</param>
public readonly record struct PixelRows(int First, int End)
{
    /// <summary>Cuts an image into strips of about equal height.</summary>
    /// <param name="strips">How many are wanted; an image with few rows gives fewer.</param>
    /// <param name="unit">Each strip but the last begins at a multiple of this.</param>
    public static IReadOnlyList<PixelRows> Strips(int height, int strips, int unit)
    {
        int units = (height + unit - 1) / unit;
        int count = Math.Clamp(strips, 1, units);
        int Border(int strip) => Math.Min(height, units * strip / count * unit);
        return [.. Enumerable.Range(0, count).Select(strip => new PixelRows(Border(strip), Border(strip + 1)))];
    }
}
