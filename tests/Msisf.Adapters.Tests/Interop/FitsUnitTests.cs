using System.Buffers.Binary;
using Msisf.Adapters.Interop;
using Msisf.Adapters.Layers;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Interop;

public class FitsUnitTests
{
    /// <summary>CFITSIO's own way, with all pixels in its memory, is the reference.</summary>
    [RequiresTheory(Part.CFitsio)]
    [InlineData(7, 5, 1)]
    [InlineData(60, 36, 1)] // 8640 bytes: whole blocks of a FITS file
    [InlineData(1023, 3, 3)]
    [InlineData(1, 1, 2)]
    public void CopyTo_DataFromElsewhere_GivesTheBytesOfCFitsio(int width, int height, int planes)
    {
        Random random = new(20120222);
        int[] numbers = [.. Enumerable.Range(0, width * height * planes).Select(_ => random.Next(int.MinValue, int.MaxValue))];
        byte[] data = new byte[sizeof(int) * numbers.Length];
        for (int i = 0; i < numbers.Length; i++)
        {
            BinaryPrimitives.WriteInt32BigEndian(data.AsSpan(sizeof(int) * i), numbers[i]);
        }

        using MemoryStream expected = new();
        using (FitsUnit whole = FitsUnit.Image(path: null, 32, LengthsOf(width, height, planes)))
        {
            whole.Put("EXTNAME", "CELL", "layer");
            whole.Write<int>(0, numbers);
            whole.CopyTo(expected);
        }

        using MemoryStream actual = new();
        using (FitsUnit header = FitsUnit.Image(path: null, 32, LengthsOf(1, 1, planes)))
        {
            header.Put("EXTNAME", "CELL", "layer");
            header.CopyTo(actual, width, height, data);
        }

        Assert.Equal(expected.ToArray(), actual.ToArray());
    }

    /// <summary>Rows of odd width, which are added in two parts.</summary>
    [RequiresFact(Part.CFitsio)]
    public void DetectorNumbers_InParts_GiveTheBytesOfCFitsio()
    {
        Random random = new(20120222);
        ushort[] numbers = [.. Enumerable.Range(0, 33 * 50).Select(_ => (ushort)random.Next(0, 0x10000))];
        using MemoryStream expected = new();
        using (FitsUnit whole = FitsUnit.PrimaryImage(33, 50))
        {
            whole.Put("BUNIT", "adu", "digital numbers");
            whole.Write<ushort>(0, numbers);
            whole.CopyTo(expected);
        }

        using MemoryStream kept = new();
        using MemoryStream actual = new();
        DetectorNumbers inParts = new(kept, 33, 50, noise: null);
        inParts.Add(numbers.AsSpan(0, 33 * 17));
        inParts.Add(numbers.AsSpan(33 * 17));
        using (FitsUnit header = FitsUnit.PrimaryImage(1, 1))
        {
            header.Put("BUNIT", "adu", "digital numbers");
            inParts.CopyTo(actual, header);
        }

        Assert.Equal(expected.ToArray(), actual.ToArray());
    }

    [RequiresFact(Part.CFitsio)]
    public void CopyTo_OddNumberOfBytes_GivesTheBytesOfCFitsio()
    {
        byte[] data = [.. Enumerable.Range(0, 33 * 11).Select(i => (byte)(3 * i))];
        using MemoryStream expected = new();
        using (FitsUnit whole = FitsUnit.Image(path: null, 8, 33, 11))
        {
            whole.Write<byte>(0, data);
            whole.CopyTo(expected);
        }

        using MemoryStream actual = new();
        using (FitsUnit header = FitsUnit.Image(path: null, 8, 1, 1))
        {
            header.CopyTo(actual, 33, 11, data);
        }

        Assert.Equal(expected.ToArray(), actual.ToArray());
    }

    private static long[] LengthsOf(int width, int height, int planes) => planes > 1 ? [width, height, planes] : [width, height];
}
