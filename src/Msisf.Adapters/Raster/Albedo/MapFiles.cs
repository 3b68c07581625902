using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>The files that hold the samples of a map.</summary>
/// <param name="Place">Path that stands for all of them: the file, or the folder with the name of the map.</param>
/// <param name="Paths">The files; those of tiles from the north, then from the west.</param>
internal sealed record MapFiles(string Place, IReadOnlyList<string> Paths)
{
    /// <summary>The files as they are now: their length in total, and a number that changes with each of them.</summary>
    /// <exception cref="BadInputException">One can't be read.</exception>
    public (long Bytes, long Written) State()
    {
        (string Name, long Bytes, long Written)[] files = [.. Paths.Select(path => FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            FileInfo file = new(path);
            return (file.Name, file.Length, file.LastWriteTimeUtc.Ticks);
        }))];
        long bytes = files.Sum(file => file.Bytes);
        if (files.Length == 1)
        {
            return (bytes, files[0].Written);
        }

        string all = string.Join('\n', files.Select(file => $"{file.Name} {file.Bytes} {file.Written}"));
        return (bytes, BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(all))));
    }

    /// <summary>SHA-256 of each file.</summary>
    /// <exception cref="BadInputException">One can't be read.</exception>
    public byte[][] Hashes() => [.. Paths.Select(path => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        using FileStream file = File.OpenRead(path);
        return SHA256.HashData(file);
    }))];

    /// <summary>
    /// The checksum of a map: that of its file; of several the SHA-256 of theirs as hexadecimal digits, one after the other.
    /// </summary>
    public static byte[] HashOf(IReadOnlyList<byte[]> hashes) => hashes.Count == 1
        ? hashes[0]
        : SHA256.HashData(Encoding.ASCII.GetBytes(string.Concat(hashes.Select(Convert.ToHexStringLower))));
}
