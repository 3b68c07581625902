using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.IO;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Keeps what was found by looking at all pixels of a large raster, beside it or in the user's cache: it takes minutes. A file that is
/// damaged, or of a raster with other lengths, times or options, counts as missing.
/// </summary>
/// <remarks>
/// Layout: a magic number, SHA-256 of what the raster is, SHA-256 of the rest; then little-endian: rows and columns of squares, halvings of
/// the level (32-bit integers), undeclared pixels (64-bit count, line, sample, value), the squares (minimum, maximum, step: 32-bit floats;
/// pixels without data: 32-bit integers), number of the level's samples and they (32-bit floats);
/// rows and pixels of a row (32-bit integers), and the border's values (32-bit floats).
/// </remarks>
internal static class RasterScanFile
{
    /// <summary>Pixels of a raster from which on it is kept: fewer are looked at in some 0.1 s.</summary>
    public const long LeastPixels = 1L << 24;

    /// <summary>Name of the file, behind that of the raster.</summary>
    public const string Extension = ".scan";

    private static ReadOnlySpan<byte> Magic => "MSISFRS2"u8;

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
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public static void Write(string path, byte[] fingerprint, RasterScan scan)
    {
        FileErrors.ToExternalPart(
            $"{path}: can't be written", () => Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!));
        AtomicFile.Write(path, stream => HashedContent.Write(stream, Head(fingerprint), writer => Write(writer, scan)));
    }

    private static byte[] Head(byte[] fingerprint) => [.. Magic, .. fingerprint];

    private static RasterScan Read(BinaryReader reader)
    {
        (int rows, int columns, int halvings) = (reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32());
        UndeclaredGaps undeclared = new(reader.ReadInt64(), reader.ReadInt32(), reader.ReadInt32(), reader.ReadSingle());
        ScannedSquare[] squares = new ScannedSquare[rows * columns];
        for (int i = 0; i < squares.Length; i++)
        {
            squares[i] = new ScannedSquare(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadInt32());
        }

        float[] level = ReadValues(reader, new float[reader.ReadInt32()]);
        RasterBorder border = new(reader.ReadInt32(), reader.ReadInt32());
        ReadValues(reader, border.Values);
        return new RasterScan(rows, columns, squares, undeclared, halvings, level, border);
    }

    private static float[] ReadValues(BinaryReader reader, float[] values)
    {
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = reader.ReadSingle();
        }

        return values;
    }

    private static void Write(BinaryWriter writer, RasterScan scan)
    {
        writer.Write(scan.Rows);
        writer.Write(scan.Columns);
        writer.Write(scan.Halvings);
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

        writer.Write(scan.Level.Length);
        Array.ForEach(scan.Level, writer.Write);
        writer.Write(scan.Border.Height);
        writer.Write(scan.Border.Width);
        Array.ForEach(scan.Border.Values, writer.Write);
    }
}

/// <summary>Where the scan of a raster is kept.</summary>
/// <param name="Places">The possible places.</param>
/// <param name="Fingerprint">What the raster is.</param>
internal sealed record KeptScan(SidecarPlaces Places, byte[] Fingerprint)
{
    /// <summary>The kept scan with its file; null if there is none, or none of this raster.</summary>
    public (string Path, RasterScan Scan)? Find() => Places.Read(
        path => RasterScanFile.TryRead(path, Fingerprint) is { } scan ? Tuple.Create(path, scan) : null) is { } kept
            ? (kept.Item1, kept.Item2)
            : null;

    /// <summary>Writes the scan.</summary>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void Write(RasterScan scan) => RasterScanFile.Write(Places.ForWriting(), Fingerprint, scan);
}
