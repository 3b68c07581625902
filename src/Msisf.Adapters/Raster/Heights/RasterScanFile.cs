using System.Security.Cryptography;
using System.Text;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Keeps what was found by looking at all pixels of a large raster, beside it or in the user's cache: it takes minutes. A file that is
/// damaged, or of a raster with other lengths, times or options, counts as missing.
/// </summary>
/// <remarks>
/// Layout: a magic number, SHA-256 of what the raster is, SHA-256 of the rest; then little-endian: where the squares begin, their rows
/// and columns (32-bit integers), undeclared pixels (64-bit count, line, sample, value), the squares (minimum, maximum, step: 32-bit
/// floats; pixels without data: 32-bit integers); rows and pixels of a row (32-bit integers), and the border's values (32-bit floats).
/// </remarks>
internal static class RasterScanFile
{
    /// <summary>Pixels of a raster from which on it is kept: fewer are looked at in some 0.1 s.</summary>
    public const long LeastPixels = 1L << 24;

    /// <summary>Name of the file, behind that of the raster.</summary>
    public const string Extension = ".scan";

    private static ReadOnlySpan<byte> Magic => "MSISFRS3"u8;

    /// <summary>What a raster is: lengths and times of its files, and what its pixels mean.</summary>
    /// <param name="meaning">Size, place and rule of the values.</param>
    /// <exception cref="IOException">A file can't be read.</exception>
    public static byte[] Fingerprint(IEnumerable<string> files, string meaning)
    {
        StringBuilder text = new(meaning);
        foreach (string file in files)
        {
            FileInfo? info = RasterFiles.IsVirtual(file) ? null : new FileInfo(file);
            using Stream? remote = info is null ? RasterFiles.OpenRead(file) : null;
            text.Append(CultureInfo.InvariantCulture, $"\n{Path.GetFileName(file)} {info?.Length ?? remote!.Length} ");
            text.Append(info?.LastWriteTimeUtc.Ticks ?? 0);
        }

        return SHA256.HashData(Encoding.UTF8.GetBytes(text.ToString()));
    }

    /// <summary>Reads a file.</summary>
    /// <returns>Null if there is none, or none of this raster.</returns>
    public static RasterScan? TryRead(string path, byte[] fingerprint)
    {
        try
        {
            using BinaryReader? reader = File.Exists(path) ? HashedContent.TryRead(File.ReadAllBytes(path), Head(fingerprint)) : null;
            return reader is null ? null : Read(reader);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // an unreadable file is as good as none
        }
    }

    /// <summary>Writes a file.</summary>
    public static void Write(Stream stream, byte[] fingerprint, RasterScan scan) =>
        HashedContent.Write(stream, Head(fingerprint), writer => Write(writer, scan));

    private static byte[] Head(byte[] fingerprint) => [.. Magic, .. fingerprint];

    private static RasterScan Read(BinaryReader reader)
    {
        SquareGrid layout = new(reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32());
        UndeclaredGaps undeclared = new(reader.ReadInt64(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadSingle());
        ScannedSquare[] squares = new ScannedSquare[layout.Rows * layout.Columns];
        for (int i = 0; i < squares.Length; i++)
        {
            squares[i] = new ScannedSquare(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadInt32());
        }

        RasterBorder border = new(reader.ReadInt32(), reader.ReadInt32());
        for (int i = 0; i < border.Values.Length; i++)
        {
            border.Values[i] = reader.ReadSingle();
        }

        return new RasterScan(layout, squares, undeclared, border);
    }

    private static void Write(BinaryWriter writer, RasterScan scan)
    {
        writer.Write(scan.Layout.RowOffset);
        writer.Write(scan.Layout.ColumnOffset);
        writer.Write(scan.Layout.Rows);
        writer.Write(scan.Layout.Columns);
        writer.Write(scan.Undeclared.Count);
        writer.Write(scan.Undeclared.Line);
        writer.Write(scan.Undeclared.Sample);
        writer.Write(scan.Undeclared.Value);
        foreach (ScannedSquare square in scan.Squares)
        {
            writer.Write(square.Min);
            writer.Write(square.Max);
            writer.Write(square.Step);
            writer.Write(square.Gaps);
        }

        writer.Write(scan.Border.Height);
        writer.Write(scan.Border.Width);
        Array.ForEach(scan.Border.Values, writer.Write);
    }
}
