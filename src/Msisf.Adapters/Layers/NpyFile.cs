using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.RegularExpressions;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>The head of an array file of NumPy, format 1.0 (numpy.lib.format).</summary>
public static partial class NpyFile
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
    /// <param name="type">Type of the numbers.</param>
    /// <param name="shape">Slowest axis first.</param>
    public static void WriteHead(Stream stream, LayerType type, params ReadOnlySpan<int> shape) =>
        WriteHead(stream, TypeText(type), shape);

    /// <summary>Reads real numbers of 64 or 32 bits that this program wrote, of two dimensions.</summary>
    /// <param name="stream">The file, which can seek.</param>
    /// <returns>The numbers by rows, and the length of a row.</returns>
    /// <exception cref="InvalidDataException">It is none of this program's.</exception>
    public static (double[] Values, int Width) ReadReals(Stream stream)
    {
        byte[] prefix = new byte[MagicLength + sizeof(ushort)];
        stream.ReadExactly(prefix);
        byte[] head = new byte[BinaryPrimitives.ReadUInt16LittleEndian(prefix.AsSpan(MagicLength))];
        stream.ReadExactly(head);
        string text = Encoding.ASCII.GetString(head);
        if (HeadOfReals().Match(text) is not { Success: true } form || form.Groups["order"].Value[0] != ByteOrder)
        {
            throw new InvalidDataException($"not a layer of real numbers: {text.Trim()}");
        }

        int[] shape = [.. ((string[])["height", "width"]).Select(side =>
            int.Parse(form.Groups[side].Value, NumberStyles.None, CultureInfo.InvariantCulture))];
        bool isDouble = form.Groups["size"].Value == "8";
        if ((long)shape[0] * shape[1] * (isDouble ? sizeof(double) : sizeof(float)) > stream.Length - stream.Position)
        {
            throw new EndOfStreamException("it is shorter than its head says.");
        }

        double[] values = new double[checked(shape[0] * shape[1])];
        if (isDouble)
        {
            stream.ReadExactly(MemoryMarshal.AsBytes(values.AsSpan()));
            return (values, shape[1]);
        }

        float[] row = new float[shape[1]];
        for (int y = 0; y < shape[0]; y++)
        {
            stream.ReadExactly(MemoryMarshal.AsBytes(row.AsSpan()));
            for (int x = 0; x < row.Length; x++)
            {
                values[(y * row.Length) + x] = row[x];
            }
        }

        return (values, shape[1]);
    }

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

    [GeneratedRegex(@"'descr': '(?<order>[<>])f(?<size>[48])', 'fortran_order': False, 'shape': \((?<height>\d+), (?<width>\d+),?\)")]
    private static partial Regex HeadOfReals();
}
