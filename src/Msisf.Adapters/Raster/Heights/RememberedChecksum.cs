using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>A checksum that was computed before, and the file that it belongs to: a line of a text file.</summary>
/// <param name="Name">Name of the file, without folders.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="WrittenTicks">When it was last written: .NET ticks, UTC.</param>
/// <param name="Sha256">64 hexadecimal digits in small letters.</param>
internal sealed record RememberedChecksum(string Name, long Bytes, long WrittenTicks, string Sha256)
{
    private const string FirstLine = "MSISF checksums 1: SHA-256, bytes, time of last change (.NET ticks, UTC), name";
    private const int Sha256Digits = 64;

    /// <summary>Reads a file of checksums; lines that are damaged are left out.</summary>
    /// <param name="path">May be missing, or null.</param>
    public static IReadOnlyList<RememberedChecksum> ReadFile(string? path)
    {
        try
        {
            string[] lines = File.Exists(path) ? File.ReadAllLines(path) : [];
            return lines.FirstOrDefault() == FirstLine ? [.. lines.Skip(1).Select(TryParse).OfType<RememberedChecksum>()] : [];
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return []; // what can't be read is computed
        }
    }

    /// <summary>Writes a file of checksums.</summary>
    public static void Write(TextWriter writer, IEnumerable<RememberedChecksum> checksums)
    {
        writer.WriteLine(FirstLine);
        foreach (RememberedChecksum one in checksums)
        {
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{one.Sha256} {one.Bytes} {one.WrittenTicks} {one.Name}"));
        }
    }

    private static RememberedChecksum? TryParse(string line) =>
        line.Split(' ', 4) is [{ Length: Sha256Digits } hash, var bytes, var ticks, var name]
            && hash.All(char.IsAsciiHexDigitLower)
            && long.TryParse(bytes, NumberStyles.None, CultureInfo.InvariantCulture, out long length)
            && long.TryParse(ticks, NumberStyles.None, CultureInfo.InvariantCulture, out long written)
            ? new RememberedChecksum(name, length, written, hash)
            : null;
}
