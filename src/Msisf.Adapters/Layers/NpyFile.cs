using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>The head of an array file of NumPy, format 1.0 (numpy.lib.format).</summary>
public static class NpyFile
{
    /// <summary>bytes: the data begins at a multiple of it.</summary>
    private const int Alignment = 64;

    /// <summary>bytes: name of the format and its version.</summary>
    private const int MagicLength = 8;

    /// <summary>Writes the head of a grey image; its levels follow by rows, in the machine's byte order.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="bytesPerPixel">1 or 2.</param>
    /// <param name="height">px.</param>
    /// <param name="width">px.</param>
    public static void WriteImageHead(Stream stream, int bytesPerPixel, int height, int width) =>
        WriteHead(stream, bytesPerPixel == 1 ? TypeText(LayerType.Unsigned8) : $"{ByteOrder}u2", height, width);

    /// <summary>Writes the head; the data follows in C order, in the machine's byte order.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="type">Of the numbers.</param>
    /// <param name="shape">Slowest axis first.</param>
    public static void WriteHead(Stream stream, LayerType type, params ReadOnlySpan<int> shape) =>
        WriteHead(stream, TypeText(type), shape);

    private static char ByteOrder => BitConverter.IsLittleEndian ? '<' : '>';

    private static void WriteHead(Stream stream, string type, params ReadOnlySpan<int> shape)
    {
        StringBuilder lengths = new();
        foreach (int length in shape)
        {
            lengths.Append(CultureInfo.InvariantCulture, $"{length}, ");
        }

        string dictionary = $"{{'descr': '{type}', 'fortran_order': False, 'shape': ({lengths.ToString().TrimEnd(' ')}), }}";
        ReadOnlySpan<byte> magic = [0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0];
        int prefix = MagicLength + sizeof(ushort);
        int total = (prefix + dictionary.Length + 1 + Alignment - 1) / Alignment * Alignment;
        byte[] head = new byte[total];
        magic.CopyTo(head);
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(MagicLength), (ushort)(total - prefix));
        head.AsSpan(prefix).Fill((byte)' ');
        Encoding.ASCII.GetBytes(dictionary, head.AsSpan(prefix));
        head[^1] = (byte)'\n';
        stream.Write(head);
    }

    private static string TypeText(LayerType type) => type switch
    {
        LayerType.Real64 => $"{ByteOrder}f8",
        LayerType.Real32 => $"{ByteOrder}f4",
        LayerType.Unsigned8 => "|u1",
        _ => $"{ByteOrder}i4",
    };
}
