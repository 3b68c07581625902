using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.App.Serving;

/// <summary>Reads pixels of a frame of which only the parts around them are drawn.</summary>
/// <param name="draw">Draws the frame, with ground truth, as a camera sees it that is a part of the frame's.</param>
/// <param name="firstInventedPart">Facets of this part and of those after it are invented; null of frames without.</param>
internal sealed class DrawnPixels(ICamera camera, Func<ICamera, NativeFrame> draw, int? firstInventedPart)
{
    /// <summary>px: pixels of one square of the image are drawn together.</summary>
    private const int SquareSide = 32;

    /// <summary>With more squares, the rectangle around all is drawn: each part costs a search for what it shows.</summary>
    private const int MaxSquares = 32;

    /// <summary>Reads what pixels show; null if it is not the Moon.</summary>
    /// <param name="points">Points of the image; what is read is the middle of the pixel that holds each.</param>
    /// <exception cref="BadInputException">A point lies outside the image.</exception>
    public SurfaceReading?[] Read(IReadOnlyList<double[]> points)
    {
        (int X, int Y)[] pixels = [.. points.Select(point => PixelOf(point[0], point[1]))];
        int[][] parts = [.. Enumerable.Range(0, pixels.Length)
            .GroupBy(index => ((pixels[index].X - 1) / SquareSide, (pixels[index].Y - 1) / SquareSide))
            .Select(part => part.ToArray())];
        SurfaceReading?[] readings = new SurfaceReading?[pixels.Length];
        foreach (int[] part in parts.Length <= MaxSquares ? parts : [[.. Enumerable.Range(0, pixels.Length)]])
        {
            ReadPart(part, pixels, readings);
        }

        return readings;
    }

    private (int X, int Y) PixelOf(double x, double y)
    {
        FrameTruth.RequireInside(camera, x, y);
        return ((int)Math.Round(x), (int)Math.Round(y));
    }

    private void ReadPart(int[] part, (int X, int Y)[] pixels, SurfaceReading?[] readings)
    {
        int left = part.Min(index => pixels[index].X) - 1;
        int top = part.Min(index => pixels[index].Y) - 1;
        ICamera window = camera.Window(
            left, top, part.Max(index => pixels[index].X) - left, part.Max(index => pixels[index].Y) - top);
        using NativeFrame frame = draw(window);
        foreach (int index in part)
        {
            (int x, int y) = pixels[index];
            readings[index] = frame.TryGet(x - left, y - top, out SurfaceHit hit, out PixelIllumination light)
                ? Reading(y, camera.RayThrough(x, y), window.RayThrough(x - left, y - top), hit, light, frame.Light.At(window, y - top))
                : null;
        }
    }

    /// <summary>A window's rays have other lengths than those of the whole.</summary>
    private SurfaceReading Reading(
        int y, Ray ray, Ray drawn, SurfaceHit hit, PixelIllumination light, SceneLight source) => SurfaceReading.Of(
        camera.BandAt(y).Camera,
        ray,
        hit with { RayParameter = hit.RayParameter * (drawn.Direction.Length / ray.Direction.Length) },
        light,
        source.PositionBodyFixed,
        firstInventedPart);
}
