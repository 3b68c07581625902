using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>The head of an array file of NumPy, format 1.0 (numpy.lib.format).</summary>
internal static class NpyFile
{
    /// <summary>bytes: the data begins at a multiple of it.</summary>
    private const int Alignment = 64;

    /// <summary>Writes the head; the data follows in C order, in the machine's byte order.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="type">Of the numbers.</param>
    /// <param name="shape">Slowest axis first.</param>
    public static void WriteHead(Stream stream, LayerType type, params ReadOnlySpan<int> shape)
    {
        StringBuilder lengths = new();
        foreach (int length in shape)
        {
            lengths.Append(CultureInfo.InvariantCulture, $"{length}, ");
        }

        string dictionary = $"{{'descr': '{TypeText(type)}', 'fortran_order': False, 'shape': ({lengths.ToString().TrimEnd(' ')}), }}";
        ReadOnlySpan<byte> magic = [0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0];
        int prefix = magic.Length + sizeof(ushort);
        int total = (prefix + dictionary.Length + 1 + Alignment - 1) / Alignment * Alignment;
        byte[] head = new byte[total];
        magic.CopyTo(head);
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(magic.Length), (ushort)(total - prefix));
        head.AsSpan(prefix).Fill((byte)' ');
        Encoding.ASCII.GetBytes(dictionary, head.AsSpan(prefix));
        head[^1] = (byte)'\n';
        stream.Write(head);
    }

    private static string TypeText(LayerType type)
    {
        char order = BitConverter.IsLittleEndian ? '<' : '>';
        return type switch
        {
            LayerType.Real64 => $"{order}f8",
            LayerType.Real32 => $"{order}f4",
            LayerType.Unsigned8 => "|u1",
            _ => $"{order}i4",
        };
    }
}
