using Msisf.Adapters.Drawing;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>
/// Draws a frame's metadata on its image (thesis figure 9.1): a red dot on each grid point that shows the Moon, a red line from it
/// along the illumination direction (none where that is undefined), and the general information in the upper left corner.
/// </summary>
public static class AnnotationRenderer
{
    private static readonly (double Red, double Green, double Blue) Red = (1.0, 0.0, 0.0);

    /// <summary>
    /// Writes the annotated image. The text is left out where a readable one does not fit (on images less than about 310 px wide or 190 px
    /// high).
    /// </summary>
    /// <param name="rendered">The rendered image, PNG.</param>
    /// <param name="annotated">Receives the annotated one, PNG without time stamps: same input, same bytes.</param>
    /// <param name="frame">The frame's general information.</param>
    /// <param name="pixels">The frame's grid points.</param>
    /// <param name="cancellation">Stops between grid points.</param>
    /// <exception cref="BadInputException">The image is not a whole PNG of the camera's size.</exception>
    /// <exception cref="ExternalPartException">Skia is missing.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Write(
        Stream rendered, Stream annotated, FrameMetadata frame, PixelSampler pixels, CancellationToken cancellation = default)
    {
        using Canvas image = Canvas.FromPng(rendered);
        if (image.Width != frame.Camera.Width || image.Height != frame.Camera.Height)
        {
            throw new BadInputException(
                $"The image has {image.Width} x {image.Height} px, the frame {frame.Camera.Width} x {frame.Camera.Height} px. "
                    + $"Render it again.");
        }

        TextBlock block = TextBlock.Of(image, AnnotationText.Lines(frame));
        DrawGrid(image, pixels, block, cancellation);
        if (frame.Navigation is { } navigation)
        {
            NavigationDrawing.Draw(image, navigation, block);
        }

        block.Draw(image);
        image.WritePng(annotated);
    }

    private static void DrawGrid(Canvas image, PixelSampler pixels, TextBlock block, CancellationToken cancellation)
    {
        // Neighbours' marks stay apart on a narrow grid and thin on a wide one.
        PixelGrid grid = pixels.Grid;
        double spacing = Math.Min(grid.SpacingH, grid.SpacingV);
        double length = Math.Clamp(0.7 * spacing, 2.0, 60.0);
        double lineWidth = Math.Clamp(0.03 * spacing, 0.7, 1.5);
        double radius = Math.Clamp(0.05 * spacing, 0.7, 2.5);

        foreach (PixelRecord pixel in pixels.Sample())
        {
            cancellation.ThrowIfCancellationRequested();

            // A canvas counts from the corner of the first pixel, rendering coordinates have its centre at 1.
            double x = pixel.H - 0.5;
            double y = pixel.V - 0.5;
            (double right, double down) = Trigonometry.SinCos(pixel.IlluminationDirection ?? 0.0);
            double reach = pixel.IlluminationDirection is null ? 0.0 : length;
            if (block.Covers(x, y) || block.Covers(x + (reach * right), y + (reach * down)))
            {
                continue;
            }

            image.DrawOutlined(Red, wider =>
            {
                image.FillCircle(x, y, radius + wider);
                if (reach > 0.0)
                {
                    image.DrawLine(x, y, x + (reach * right), y + (reach * down), lineWidth + (2.0 * wider));
                }
            });
        }
    }
}

/// <summary>The block of text in the upper left corner, under which nothing else is drawn.</summary>
internal sealed class TextBlock
{
    /// <summary>px: the smallest readable size.</summary>
    private const double MinFontSize = 8.0;

    /// <summary>px: larger text only hides more of the image.</summary>
    private const double LargestFontSize = 24.0;

    /// <summary>Line height as a multiple of the font size.</summary>
    private const double LineSpacing = 1.35;

    /// <summary>Share of the image's width that the text block takes, if the font sizes allow it.</summary>
    private const double TextWidthShare = 0.6;

    /// <summary>White text on it can be read over sunlit ground.</summary>
    private const double Backing = 0.75;

    private readonly string[] _lines;
    private readonly double _size;
    private readonly double _width;
    private readonly double _height;

    private TextBlock(string[] lines, double size, double width, double height) =>
        (_lines, _size, _width, _height) = (lines, size, width, height);

    private double Margin => 0.5 * _size;

    /// <summary>Lays a text out; it is left out where a readable one does not fit.</summary>
    public static TextBlock Of(Canvas image, string[] lines)
    {
        double widthAtSize1 = lines.Max(line => image.MeasureText(line, LargestFontSize)) / LargestFontSize;
        double size = Math.Clamp(TextWidthShare * image.Width / widthAtSize1, MinFontSize, LargestFontSize);
        double width = lines.Max(line => image.MeasureText(line, size)) + size;
        double height = (size * LineSpacing * lines.Length) + size;
        return width > image.Width || height > 0.5 * image.Height
            ? new TextBlock([], size, 0.0, 0.0)
            : new TextBlock(lines, size, width, height);
    }

    /// <summary>Whether a point of the image lies under the text.</summary>
    public bool Covers(double x, double y) => x < _width && y < _height;

    /// <summary>Draws it.</summary>
    public void Draw(Canvas image)
    {
        image.SetColor(0.0, 0.0, 0.0, Backing);
        image.FillRectangle(0.0, 0.0, _width, _height);
        image.SetColor(1.0, 1.0, 1.0, 1.0);
        for (int i = 0; i < _lines.Length; i++)
        {
            image.DrawText(_lines[i], Margin, Margin + (_size * ((LineSpacing * i) + 1.0)), _size);
        }
    }
}

/// <summary>The text block of an annotated image (thesis figure 9.1), with rounded numbers; the meta file has all digits.</summary>
internal static class AnnotationText
{
    /// <summary>The lines of the block.</summary>
    public static string[] Lines(FrameMetadata frame)
    {
        UnitQuaternion orientation = frame.Camera.MoonFromCamera;
        return
        [
            Invariant($"Simulation time:    {frame.SimulationTime.ToIsoUtc()} (MJD {frame.SimulationTime.Mjd:R})"),
            Invariant($"S/C position:       {Components(frame.Camera.PositionBodyFixed)} m"),
            Invariant($"S/C orientation:    {orientation.X:F6}, {orientation.Y:F6}, {orientation.Z:F6}, {orientation.W:F6} (x, y, z, r)"),
            Invariant($"Sun position:       {Components(frame.SunPositionBodyFixed)} m"),
            Invariant($"Flight altitude:    {frame.FlightAltitude:F0} m ({frame.HeightOverTerrain:F0} m over the terrain)"),
            Invariant($"Elevation model:    {frame.Elevation.ProductId}{(frame.Elevation.IsSynthetic ? " (SYNTHETIC)" : string.Empty)}"),
            Invariant($"Surface resolution: {frame.Elevation.Resolution}{Drawn(frame.Elevation)}"),
            Invariant($"Field of view:      {frame.FieldOfViewDegrees:R} deg"),
            Invariant($"MSIS version:       {frame.Version}"),
        ];
    }

    /// <summary>The levels of detail, where the model itself is not all that was drawn.</summary>
    private static string Drawn(DrawnElevation elevation) => elevation.CoarsestDrawn == elevation.Resolution ? string.Empty
        : elevation.CoarsestDrawn == elevation.FinestDrawn ? Invariant($", drawn at {elevation.FinestDrawn.NumberText}")
        : Invariant($", drawn at {elevation.CoarsestDrawn.NumberText} to {elevation.FinestDrawn.NumberText}");

    private static string Components(Vector3D v) => Invariant($"{v.X:F0}, {v.Y:F0}, {v.Z:F0}");
}
