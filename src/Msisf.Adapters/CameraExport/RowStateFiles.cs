using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.RegularExpressions;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.CameraExport;

/// <summary>Reads the states of a scan's rows from the layers beside its meta file.</summary>
internal static partial class RowStateFiles
{
    private const int FitsBlock = 2880;

    private const int FitsCard = 80;

    private const int NpyMagic = 10;

    /// <summary>The names of the files in which they can be.</summary>
    /// <param name="metaFile">Path of the meta file.</param>
    public static string NamesFor(string metaFile)
    {
        string stem = Path.GetFileNameWithoutExtension(metaFile);
        return $"{stem}.rowstates.npy, {stem}.fits";
    }

    /// <summary>Reads them.</summary>
    /// <param name="metaFile">Path of the meta file.</param>
    /// <returns>The numbers, row by row (<see cref="RowStates"/>); null if no file has them.</returns>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public static double[]? Find(string metaFile)
    {
        string npy = Path.ChangeExtension(metaFile, ".rowstates.npy");
        string fits = Path.ChangeExtension(metaFile, ".fits");
        return File.Exists(npy) ? Read(npy, OfNpy) : File.Exists(fits) ? Read(fits, OfFits) : null;
    }

    private static double[]? Read(string path, Func<Stream, double[]?> read)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            return read(stream);
        }
        catch (Exception exception) when (exception is EndOfStreamException or FormatException or OverflowException)
        {
            throw new BadInputException($"{path}: it is damaged: {exception.Message} Make the image again.", exception);
        }
    }

    private static double[] OfNpy(Stream stream)
    {
        byte[] magic = Bytes(stream, NpyMagic);
        string head = Encoding.ASCII.GetString(Bytes(stream, BinaryPrimitives.ReadUInt16LittleEndian(magic.AsSpan(NpyMagic - 2))));
        Match match = Head().Match(head);
        return match.Success && int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture) is var rows
            && match.Groups[2].Value == RowStates.Names.Count.ToString(CultureInfo.InvariantCulture)
                ? [.. MemoryMarshal.Cast<byte, double>(Bytes(stream, (long)rows * RowStates.Names.Count * sizeof(double)))]
                : throw new FormatException("its head is not that of row states.");
    }

    /// <summary>The extension ROWSTATES, behind whatever stands before it.</summary>
    private static double[]? OfFits(Stream stream)
    {
        while (stream.Position < stream.Length)
        {
            Dictionary<string, string> keys = FitsHead(stream);
            long Key(string key, long otherwise) =>
                keys.TryGetValue(key, out string? text) ? long.Parse(text, CultureInfo.InvariantCulture) : otherwise;
            long axes = Key("NAXIS", 0);
            long count = axes == 0 ? 0 : 1;
            for (int axis = 1; axis <= axes; axis++)
            {
                count = checked(count * Key(Invariant($"NAXIS{axis}"), 0));
            }

            long bytes = checked(Math.Abs(Key("BITPIX", 8)) / 8 * Key("GCOUNT", 1) * (Key("PCOUNT", 0) + count));
            if (keys.GetValueOrDefault("EXTNAME") == "ROWSTATES")
            {
                byte[] data = Bytes(stream, bytes);
                return [.. Enumerable.Range(0, data.Length / sizeof(double))
                    .Select(i => BinaryPrimitives.ReadDoubleBigEndian(data.AsSpan(i * sizeof(double))))];
            }

            stream.Position += (bytes + FitsBlock - 1) / FitsBlock * FitsBlock;
        }

        return null;
    }

    private static Dictionary<string, string> FitsHead(Stream stream)
    {
        Dictionary<string, string> keys = [];
        while (true)
        {
            string block = Encoding.ASCII.GetString(Bytes(stream, FitsBlock));
            for (int at = 0; at < FitsBlock; at += FitsCard)
            {
                string key = block.Substring(at, 8).TrimEnd();
                if (key == "END")
                {
                    return keys;
                }

                if (block.Substring(at + 8, 2) == "= ")
                {
                    keys[key] = block.Substring(at + 10, FitsCard - 10).Split('/')[0].Trim(' ', '\'').TrimEnd();
                }
            }
        }
    }

    private static byte[] Bytes(Stream stream, long count)
    {
        if (count < 0 || count > stream.Length - stream.Position)
        {
            throw new EndOfStreamException("it is shorter than its head says.");
        }

        byte[] bytes = new byte[count];
        stream.ReadExactly(bytes);
        return bytes;
    }

    [GeneratedRegex(@"^\{'descr': '<f8', 'fortran_order': False, 'shape': \((\d+), (\d+),?\), \}")]
    private static partial Regex Head();
}
