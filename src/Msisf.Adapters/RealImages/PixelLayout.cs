using System.Buffers.Binary;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>Where and how the pixels of an image lie in a file.</summary>
/// <param name="Offset">Bytes before the first pixel.</param>
/// <param name="Type">Type of the numbers.</param>
/// <param name="IsBigEndian">Their byte order.</param>
/// <param name="Size">Bands, lines and samples.</param>
/// <param name="Strides">Bytes from a band, line and sample to the next one; not used with tiles.</param>
public sealed record PixelLayout(
    string Path, long Offset, PixelType Type, bool IsBigEndian, (int Bands, int Lines, int Samples) Size,
    (long Band, long Line, int Sample) Strides)
{
    /// <summary>Lines and samples of a tile, where the pixels lie in tiles; they fill whole ones.</summary>
    public (int Lines, int Samples)? Tile { get; init; }

    /// <summary>Added to each number times <see cref="Multiplier"/>.</summary>
    public double Base { get; init; }

    /// <summary>Times each number.</summary>
    public double Multiplier { get; init; } = 1.0;

    /// <summary>Tells numbers that stand for no value.</summary>
    public Func<double, bool> IsMissing { get; init; } = static _ => false;

    /// <summary>Bytes of a number.</summary>
    public int Bytes => new PdsSampleType(Type, IsBigEndian).Bytes;

    /// <summary>Bytes that the file has at least if it is whole.</summary>
    private long End => Tile is { } tile
        ? Offset
            + (Size.Bands * Tiles(Size.Lines, tile.Lines) * Tiles(Size.Samples, tile.Samples) * tile.Lines * tile.Samples * Bytes)
        : Offset + ((Size.Bands - 1) * Strides.Band) + ((Size.Lines - 1) * Strides.Line) + ((Size.Samples - 1L) * Strides.Sample) + Bytes;

    /// <summary>Whether there are pixels; a label alone, without its pixels, has none.</summary>
    /// <exception cref="BadInputException">There are some of them only.</exception>
    public bool AreThere()
    {
        long length = File.Exists(Path) ? new FileInfo(Path).Length : 0;
        return length >= End || (length <= Offset
            ? false
            : throw new BadInputException(Invariant(
                $"{Path}: {length} bytes, and its label says {End}: the pixels are cut off. Get the file again.")));
    }

    /// <summary>Reads lines of a band.</summary>
    /// <param name="band">From 0.</param>
    /// <param name="first">The first line, from 0.</param>
    /// <returns>By lines; NaN where there is no value.</returns>
    /// <exception cref="BadInputException">The file can't be read.</exception>
    public float[] Read(int band, int first, int count) => FileErrors.ToBadInput($"{Path}: can't be read", () =>
    {
        float[] pixels = new float[checked(count * Size.Samples)];
        using FileStream file = new(Path, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 16);
        int run = Tile?.Samples ?? Size.Samples;
        int step = Tile is null ? Strides.Sample : Bytes;
        byte[] bytes = new byte[((run - 1) * step) + Bytes];
        for (int line = 0; line < count; line++)
        {
            for (int sample = 0; sample < Size.Samples; sample += run)
            {
                file.Position = PlaceOf(band, first + line, sample);
                file.ReadExactly(bytes);
                int numbers = Math.Min(run, Size.Samples - sample);
                for (int i = 0; i < numbers; i++)
                {
                    double number = Number(bytes.AsSpan(i * step));
                    pixels[(line * Size.Samples) + sample + i] =
                        IsMissing(number) || !double.IsFinite(number) ? float.NaN : (float)(Base + (Multiplier * number));
                }
            }
        }

        return pixels;
    });

    private static long Tiles(int size, int ofTile) => ((long)size + ofTile - 1) / ofTile;

    private long PlaceOf(int band, int line, int sample) => Offset + (Tile is not { } tile
        ? (band * Strides.Band) + (line * Strides.Line) + ((long)sample * Strides.Sample)
        : Bytes * (((((((band * Tiles(Size.Lines, tile.Lines)) + (line / tile.Lines)) * Tiles(Size.Samples, tile.Samples))
            + (sample / tile.Samples)) * tile.Lines) + (line % tile.Lines)) * tile.Samples));

    private double Number(ReadOnlySpan<byte> bytes) => (Type, IsBigEndian) switch
    {
        (PixelType.Unsigned8, _) => bytes[0],
        (PixelType.Signed16, true) => BinaryPrimitives.ReadInt16BigEndian(bytes),
        (PixelType.Signed16, false) => BinaryPrimitives.ReadInt16LittleEndian(bytes),
        (PixelType.Unsigned16, true) => BinaryPrimitives.ReadUInt16BigEndian(bytes),
        (PixelType.Unsigned16, false) => BinaryPrimitives.ReadUInt16LittleEndian(bytes),
        (PixelType.Signed32, true) => BinaryPrimitives.ReadInt32BigEndian(bytes),
        (PixelType.Signed32, false) => BinaryPrimitives.ReadInt32LittleEndian(bytes),
        (PixelType.Real32, true) => BinaryPrimitives.ReadSingleBigEndian(bytes),
        (PixelType.Real32, false) => BinaryPrimitives.ReadSingleLittleEndian(bytes),
        (PixelType.Real64, true) => BinaryPrimitives.ReadDoubleBigEndian(bytes),
        _ => BinaryPrimitives.ReadDoubleLittleEndian(bytes),
    };
}
