using System.Buffers;
using System.Buffers.Binary;
using System.Runtime.InteropServices;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Render;

/// <summary>A grey PNG whose rows are added as they become known; the bytes do not depend on how many come at once.</summary>
public sealed class PngImage : IDisposable
{
    private readonly Stream _destination;
    private readonly PngRows _rows;
    private readonly uint? _greatestNumber;

    /// <summary>Writes the head.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <param name="bitDepth">Bits of a level: 8 or 16.</param>
    /// <param name="transfer">What the levels mean, for the file's gamma.</param>
    /// <param name="significantBits">Bits of a detector's numbers, which are scaled to all 16; null for levels.</param>
    public PngImage(Stream destination, int width, int height, byte bitDepth, GreyTransfer transfer, byte? significantBits = null)
    {
        _destination = destination;
        PngWriter.WriteHead(destination, width, height, bitDepth, transfer);
        if (significantBits is byte bits)
        {
            _greatestNumber = (1u << bits) - 1;
            PngChunk.Write(destination, "sBIT"u8, [bits]);
        }

        _rows = new PngRows(destination, bitDepth / 8 * width, PngWriter.RunsOnly());
    }

    /// <summary>An image of a detector's numbers (<see cref="PngWriter.WriteNumbers"/>).</summary>
    public static PngImage OfNumbers(Stream destination, int width, int height, int bits) =>
        new(destination, width, height, 16, GreyTransfer.Linear, (byte)bits);

    /// <summary>Adds rows of 8 bits.</summary>
    public void Add(ReadOnlySpan<byte> levels) => _rows.Add(levels);

    /// <summary>Adds rows of 16 bits, or of a detector's numbers.</summary>
    public void Add(ReadOnlySpan<ushort> levels)
    {
        ushort[] samples = ArrayPool<ushort>.Shared.Rent(levels.Length);
        for (int i = 0; i < levels.Length; i++)
        {
            samples[i] = _greatestNumber is { } max ? (ushort)(((levels[i] * (uint)ushort.MaxValue) + (max / 2)) / max) : levels[i];
        }

        Span<ushort> networkOrder = samples.AsSpan(0, levels.Length);
        if (BitConverter.IsLittleEndian)
        {
            BinaryPrimitives.ReverseEndianness(networkOrder, networkOrder);
        }

        _rows.Add(MemoryMarshal.AsBytes<ushort>(networkOrder));
        ArrayPool<ushort>.Shared.Return(samples);
    }

    /// <summary>Ends the image.</summary>
    public void Dispose()
    {
        _rows.Dispose();
        PngChunk.Write(_destination, "IEND"u8, []);
    }
}
