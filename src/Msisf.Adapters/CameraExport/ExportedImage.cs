using System.Runtime.InteropServices;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Render;
using Msisf.Core.Detector;
using Msisf.Core.Render;

namespace Msisf.Adapters.CameraExport;

/// <summary>The numbers of an image, for formats that hold pixels and not only the camera.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="IsDigital">Whether they are what a detector read out (DN); otherwise they are radiance factors (I/F).</param>
/// <param name="ReadRow">Puts the numbers of a row, from 0, into a span.</param>
public sealed record ExportedImage(int Width, int Height, bool IsDigital, ExportedImage.RowReader ReadRow)
{
    /// <summary>The layer from which an image is read again: radiance factors as an array of NumPy.</summary>
    private const string LayerEnding = ".radiance-factor.npy";

    /// <summary>The image of a frame that was drawn just now.</summary>
    /// <param name="truth">Its radiance factors.</param>
    /// <param name="detected">What its detector read out; null without one.</param>
    public static ExportedImage Of(IGroundTruth truth, DetectorImage? detected) =>
        new(truth.Camera.Width, truth.Camera.Height, detected is not null, (row, numbers) =>
        {
            for (int x = 0; x < numbers.Length; x++)
            {
                int at = (row * numbers.Length) + x;
                numbers[x] = detected is null ? (float)truth.RadianceFactors[at] : detected.Numbers[at];
            }
        });

    /// <summary>Reads the image of a frame that is there: of a detector from its PNG, others from the layer of radiance factors.</summary>
    /// <param name="frame">What that says.</param>
    /// <exception cref="BadInputException">Neither has the numbers of the image.</exception>
    public static ExportedImage Read(string metaFile, ExportedFrame frame)
    {
        (int width, int height) = (frame.Camera.Width, frame.Height);
        string image = Path.ChangeExtension(metaFile, ".png");
        string layer = Path.ChangeExtension(metaFile, LayerEnding);
        return FileErrors.ToBadInput($"{metaFile}: the files beside it can't be read", () =>
        {
            if (File.Exists(image) && DetectorNumbers(image) is { } numbers && numbers.Length == width * height)
            {
                return new ExportedImage(width, height, IsDigital: true, (row, values) =>
                {
                    for (int x = 0; x < width; x++)
                    {
                        values[x] = numbers[(row * width) + x];
                    }
                });
            }

            return File.Exists(layer) ? OfLayer(layer, width, height) : throw new BadInputException(
                $"{layer} is not there, and the meta file alone has no pixels. Draw the image with --camera-model, or with "
                    + "--layers radiance-factor --layers-format npy.");
        });
    }

    /// <summary>Writes the pixels by rows from the top, least significant byte first.</summary>
    /// <param name="stream">Receives them.</param>
    /// <param name="undefined">Stands for NaN.</param>
    /// <param name="isFromFoot">Whether the lowest row comes first.</param>
    internal void WritePixels(Stream stream, float undefined, bool isFromFoot = false)
    {
        float[] row = new float[Width];
        for (int y = 0; y < Height; y++)
        {
            ReadRow(isFromFoot ? Height - 1 - y : y, row);
            row.AsSpan().Replace(float.NaN, undefined);
            stream.Write(MemoryMarshal.AsBytes(row.AsSpan()));
        }
    }

    private static ushort[]? DetectorNumbers(string path)
    {
        using FileStream stream = File.OpenRead(path);
        return PngRaster.Read(stream, path).DetectorNumbers();
    }

    private static ExportedImage OfLayer(string path, int width, int height)
    {
        double[] values;
        try
        {
            using FileStream stream = File.OpenRead(path);
            (values, int rowLength) = NpyFile.ReadReals(stream);
            if (rowLength != width || values.Length != width * height)
            {
                throw new InvalidDataException($"an array of {values.Length / rowLength} x {rowLength} numbers");
            }
        }
        catch (Exception exception) when (exception is InvalidDataException or OverflowException or EndOfStreamException)
        {
            throw new BadInputException(
                $"{path}: is not an array of {height} x {width} real numbers as msis writes it. Draw the image again.", exception);
        }

        return new ExportedImage(width, height, IsDigital: false, (row, numbers) =>
        {
            for (int x = 0; x < width; x++)
            {
                numbers[x] = (float)values[(row * width) + x];
            }
        });
    }

    /// <summary>Reads a row of an image.</summary>
    /// <param name="row">From 0.</param>
    /// <param name="numbers">Receives its numbers.</param>
    public delegate void RowReader(int row, Span<float> numbers);
}
