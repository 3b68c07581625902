using Msisf.Adapters.Drawing;
using Msisf.Adapters.Render;

namespace Msisf.Adapters.Metadata;

/// <summary>Draws small images of many frames on one, each with its step.</summary>
public static class ContactSheet
{
    /// <summary>The most images on a sheet. If there are more, this many are shown, evenly spread from the first to the last.</summary>
    public const int MaxImages = 100;

    private const int Columns = 10;

    /// <summary>px: the longer side of a small image.</summary>
    private const int Side = 160;

    /// <summary>px: the text below a small image, and the space between them.</summary>
    private const int TextHeight = 16;

    private const double FontSize = 11.0;

    /// <summary>Grey between the black of night and space and the white of the text.</summary>
    private const double BackgroundGrey = 0.2;

    /// <summary>Writes the sheet.</summary>
    /// <param name="destination">Receives it, PNG without time stamps: same images, same bytes.</param>
    /// <param name="frames">Step and image file of each frame, in the order in which they are shown; at least one.</param>
    /// <param name="cancellation">Stops between two images.</param>
    /// <exception cref="BadInputException">A file holds no whole image.</exception>
    /// <exception cref="ExternalPartException">Skia is missing, or a file can't be read.</exception>
    public static void Write(Stream destination, IReadOnlyList<(int Step, string Path)> frames, CancellationToken cancellation)
    {
        int count = Math.Min(frames.Count, MaxImages);
        int columns = Math.Min(count, Columns);
        int rows = (count + columns - 1) / columns;
        using Canvas sheet = Canvas.Black(columns * (Side + TextHeight), rows * (Side + (2 * TextHeight)));
        sheet.SetColor(BackgroundGrey, BackgroundGrey, BackgroundGrey, 1.0);
        sheet.FillRectangle(0.0, 0.0, sheet.Width, sheet.Height);
        for (int index = 0; index < count; index++)
        {
            cancellation.ThrowIfCancellationRequested();
            (int step, string path) = frames[count == 1 ? 0 : (int)((long)index * (frames.Count - 1) / (count - 1))];
            double left = ((index % columns) * (Side + TextHeight)) + (TextHeight / 2.0);
            double top = (index / columns * (Side + (2 * TextHeight))) + (TextHeight / 2.0);
            using Canvas image = Read(path);
            double scale = (double)Side / Math.Max(image.Width, image.Height);
            sheet.DrawImage(image, left + ((Side - (scale * image.Width)) / 2.0), top + ((Side - (scale * image.Height)) / 2.0), scale);
            sheet.SetColor(1.0, 1.0, 1.0, 1.0);
            sheet.DrawText(step.ToString(CultureInfo.InvariantCulture), left, top + Side + FontSize, FontSize);
        }

        sheet.WritePng(destination);
    }

    private static Canvas Read(string path)
    {
        PngFile.CheckFile(path); // says what is wrong with a damaged file
        try
        {
            using FileStream stream = File.OpenRead(path);
            return Canvas.FromPng(stream);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException($"{path}: can't be read: {exception.Message}", exception);
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{path}: {exception.Message} Run msis verify.", exception);
        }
    }
}
