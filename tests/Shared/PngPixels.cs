using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace Msisf.TestSupport;

/// <summary>
/// The samples of a PNG image, 8 or 16 bits, grey or RGB with or without alpha, not interlaced: an independent reader for image tests.
/// </summary>
internal sealed class PngPixels
{
    private readonly ushort[] _samples;

    private PngPixels(int width, int height, int channels, int bitDepth, ushort[] samples)
    {
        Width = width;
        Height = height;
        Channels = channels;
        BitDepth = bitDepth;
        _samples = samples;
    }

    public int Width { get; }

    public int Height { get; }

    /// <summary>1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha.</summary>
    public int Channels { get; }

    /// <summary>8 or 16.</summary>
    public int BitDepth { get; }

    /// <summary>A sample as stored; pixel (0, 0) is the upper left one.</summary>
    public int this[int x, int y, int channel] => _samples[(((y * Width) + x) * Channels) + channel];

    public static PngPixels Read(string path)
    {
        using FileStream stream = File.OpenRead(path);
        return Read(stream);
    }

    public static PngPixels Read(Stream png)
    {
        byte[] word = new byte[8];
        png.ReadExactly(word);
        byte[] header = [];
        using MemoryStream compressed = new();
        for (string type = string.Empty; type != "IEND";)
        {
            png.ReadExactly(word);
            byte[] data = new byte[BinaryPrimitives.ReadInt32BigEndian(word)];
            type = Encoding.ASCII.GetString(word, 4, 4);
            png.ReadExactly(data);
            png.ReadExactly(word, 0, 4);
            if (type == "IHDR")
            {
                header = data;
            }
            else if (type == "IDAT")
            {
                compressed.Write(data);
            }
        }

        int channels = header[9] switch
        {
            0 => 1,
            2 => 3,
            4 => 2,
            6 => 4,
            byte code => throw new NotSupportedException(
            $"colour type {code}")
        };
        if (header[8] is not (8 or 16) || header[12] != 0)
        {
            throw new NotSupportedException($"{header[8]} bits, interlace {header[12]}");
        }

        compressed.Position = 0;
        using ZLibStream rows = new(compressed, CompressionMode.Decompress);
        int width = BinaryPrimitives.ReadInt32BigEndian(header);
        int height = BinaryPrimitives.ReadInt32BigEndian(header.AsSpan(4));
        return new PngPixels(width, height, channels, header[8], Samples(rows, width * channels, height, channels, header[8] / 8));
    }

    /// <summary>One sample of every pixel as parts of full scale, [y, x].</summary>
    public double[,] ChannelParts(int channel)
    {
        double fullScale = (1 << BitDepth) - 1;
        double[,] parts = new double[Height, Width];
        for (int y = 0; y < Height; y++)
        {
            for (int x = 0; x < Width; x++)
            {
                parts[y, x] = this[x, y, channel] / fullScale;
            }
        }

        return parts;
    }

    private static ushort[] Samples(Stream rows, int samplesPerRow, int height, int channels, int bytesPerSample)
    {
        ushort[] samples = new ushort[samplesPerRow * height];
        byte[] previous = new byte[samplesPerRow * bytesPerSample];
        byte[] row = new byte[previous.Length];
        for (int y = 0; y < height; y++)
        {
            int filter = rows.ReadByte();
            rows.ReadExactly(row);
            Unfilter(filter, row, previous, channels * bytesPerSample);
            for (int i = 0; i < samplesPerRow; i++)
            {
                samples[(y * samplesPerRow) + i] =
                    bytesPerSample == 1 ? row[i] : BinaryPrimitives.ReadUInt16BigEndian(row.AsSpan(2 * i));
            }

            (previous, row) = (row, previous);
        }

        return samples;
    }

    /// <summary>ISO/IEC 15948, section 9: each byte is stored as the difference from a guess by its neighbours.</summary>
    private static void Unfilter(int filter, byte[] row, byte[] above, int pixelBytes)
    {
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < pixelBytes ? 0 : row[i - pixelBytes];
            int aboveLeft = i < pixelBytes ? 0 : above[i - pixelBytes];
            row[i] += filter switch
            {
                0 => 0,
                1 => (byte)left,
                2 => above[i],
                3 => (byte)((left + above[i]) / 2),
                4 => (byte)Paeth(left, above[i], aboveLeft),
                _ => throw new InvalidDataException($"filter {filter}"),
            };
        }
    }

    private static int Paeth(int left, int above, int aboveLeft)
    {
        int guess = left + above - aboveLeft;
        int toLeft = Math.Abs(guess - left);
        int toAbove = Math.Abs(guess - above);
        int toAboveLeft = Math.Abs(guess - aboveLeft);
        return toLeft <= toAbove && toLeft <= toAboveLeft ? left : toAbove <= toAboveLeft ? above : aboveLeft;
    }
}
