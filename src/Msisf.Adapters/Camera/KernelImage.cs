using System.Buffers.Binary;
using System.Text;
using System.Text.RegularExpressions;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the numbers of a small square image: a FITS file (primary image) or an array file of NumPy.</summary>
internal static partial class KernelImage
{
    private const int FitsBlock = 2880;
    private const int FitsCard = 80;

    /// <summary>Reads an image.</summary>
    /// <param name="content">The file.</param>
    /// <param name="path">For messages.</param>
    /// <returns>By rows, in the order of the file; the first row of a FITS file is the top one, as in this program's files.</returns>
    /// <exception cref="BadInputException">Neither FITS nor NumPy, not two square dimensions, or cut off.</exception>
    public static double[] Parse(byte[] content, string path)
    {
        ReadOnlySpan<byte> magic = [0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y'];
        return content.AsSpan().StartsWith(magic) ? Npy(content, path)
            : content.AsSpan().StartsWith("SIMPLE  ="u8) ? Fits(content, path)
            : throw Wrong(path, "it is neither a FITS nor a NumPy file");
    }

    private static double[] Npy(byte[] content, string path)
    {
        const int PrefixLength = 10;
        int start = content.Length > PrefixLength
            ? PrefixLength + BinaryPrimitives.ReadUInt16LittleEndian(content.AsSpan(8))
            : int.MaxValue;
        if (start > content.Length || content[6] != 1)
        {
            throw Wrong(path, "its head is cut off, or not of format 1.0");
        }

        Match head = NpyHead().Match(Encoding.ASCII.GetString(content, PrefixLength, start - PrefixLength));
        return head.Success && head.Groups["rows"].Value == head.Groups["columns"].Value
            ? Numbers(content.AsSpan(start), Length(head.Groups["rows"].Value, path), head.Groups["type"].Value[1..] switch
            {
                "f8" => BinaryPrimitives.ReadDoubleLittleEndian,
                _ => static bytes => BinaryPrimitives.ReadSingleLittleEndian(bytes),
            }, int.Parse(head.Groups["type"].Value[2..], CultureInfo.InvariantCulture), path)
            : throw Wrong(path, "a square array of two dimensions is needed, of little-endian numbers <f4 or <f8 in C order");
    }

    private static double[] Fits(byte[] content, string path)
    {
        Dictionary<string, string> cards = new(StringComparer.Ordinal);
        int place = 0;
        for (; !cards.ContainsKey("END"); place += FitsCard)
        {
            if (place + FitsCard > content.Length)
            {
                throw Wrong(path, "its header has no end");
            }

            string card = Encoding.ASCII.GetString(content, place, FitsCard);
            cards[card[..8].TrimEnd()] = card.Length > 10 && card[8] == '=' ? card[10..].Split('/')[0].Trim() : string.Empty;
        }

        string Card(string key) => cards.TryGetValue(key, out string? value) ? value : string.Empty;
        if (Card("NAXIS") != "2" || Card("NAXIS1") != Card("NAXIS2") || cards.ContainsKey("BSCALE") || cards.ContainsKey("BZERO"))
        {
            throw Wrong(path, "a square primary image of two dimensions is needed, without BSCALE and BZERO");
        }

        int start = (place + FitsBlock - 1) / FitsBlock * FitsBlock;
        ReadOnlySpan<byte> data = start <= content.Length ? content.AsSpan(start) : [];
        int length = Length(Card("NAXIS1"), path);
        return Card("BITPIX") switch
        {
            "-64" => Numbers(data, length, BinaryPrimitives.ReadDoubleBigEndian, sizeof(double), path),
            "-32" => Numbers(data, length, static bytes => BinaryPrimitives.ReadSingleBigEndian(bytes), sizeof(float), path),
            _ => throw Wrong(path, "BITPIX -32 or -64 is needed"),
        };
    }

    private static int Length(string side, string path) =>
        int.TryParse(side, NumberStyles.None, CultureInfo.InvariantCulture, out int length) && length is > 0 and < 1000
            ? length * length
            : throw Wrong(path, $"a side of '{side}' px is out of range");

    private static double[] Numbers(ReadOnlySpan<byte> data, int count, Func<ReadOnlySpan<byte>, double> read, int size, string path)
    {
        if (data.Length < count * size)
        {
            throw Wrong(path, $"{count * size} bytes of numbers are needed, {data.Length} are there");
        }

        double[] numbers = new double[count];
        for (int i = 0; i < count; i++)
        {
            numbers[i] = read(data.Slice(i * size, size));
        }

        return numbers;
    }

    private static BadInputException Wrong(string path, string why) => new($"{path}: the PSF kernel can't be used: {why}.");

    [GeneratedRegex(@"'descr': '(?<type><f[48])', 'fortran_order': False, 'shape': \((?<rows>\d+), (?<columns>\d+)\)")]
    private static partial Regex NpyHead();
}
