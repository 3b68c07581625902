using System.Buffers.Binary;
using System.Runtime.InteropServices;
using Msisf.Adapters.Interop;
using Msisf.Core.Detector;
using Msisf.Core.Scene;

namespace Msisf.Adapters.Layers;

/// <summary>The digital numbers of an image, which may be read out some rows at a time, as a FITS file holds them.</summary>
/// <param name="stream">Keeps them: written and read here, closed elsewhere.</param>
/// <param name="width">px.</param>
/// <param name="height">px.</param>
/// <param name="noise">The noise of the image; null for that of the camera file.</param>
public sealed class DetectorNumbers(Stream stream, int width, int height, NoiseSeed? noise)
{
    /// <summary>BZERO: numbers without sign are stored with one, less so many.</summary>
    private const ushort Zero = 0x8000;

    private uint _sum;

    /// <summary>The noise of the image.</summary>
    public NoiseSeed? Noise => noise;

    /// <summary>Those of a whole image.</summary>
    public static DetectorNumbers Of(DetectorImage image)
    {
        DetectorNumbers numbers = new(new MemoryStream(image.Numbers.Length * sizeof(ushort)), image.Width, image.Height, image.Noise);
        for (int row = 0; row < image.Height; row++)
        {
            numbers.Add(image.Numbers.AsSpan(row * image.Width, image.Width));
        }

        return numbers;
    }

    /// <summary>Adds the next rows.</summary>
    public void Add(ReadOnlySpan<ushort> numbers)
    {
        ushort[] stored = new ushort[numbers.Length];
        for (int i = 0; i < stored.Length; i++)
        {
            ushort number = (ushort)(numbers[i] ^ Zero);
            stored[i] = BitConverter.IsLittleEndian ? BinaryPrimitives.ReverseEndianness(number) : number;
        }

        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes<ushort>(stored);
        _sum = FitsSum.Of(_sum, FitsSum.Of(bytes, stream.Position));
        stream.Write(bytes);
    }

    /// <summary>Copies them to a FITS file, with the header of a unit of one pixel.</summary>
    internal void CopyTo(Stream file, FitsUnit unit)
    {
        file.Write(unit.HeaderOf(width, height, _sum));
        stream.Position = 0;
        stream.CopyTo(file);
        file.Write(new byte[FitsUnit.FillOf(stream.Length)]);
    }
}
