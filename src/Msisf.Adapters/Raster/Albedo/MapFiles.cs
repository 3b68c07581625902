using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.IO;

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
        (string Name, long Bytes, long Written)[] files = OfEach(path =>
        {
            FileInfo file = new(path);
            return (file.Name, file.Length, file.LastWriteTimeUtc.Ticks);
        });
        string all = string.Join('\n', files.Select(file => $"{file.Name} {file.Bytes} {file.Written}"));
        return (
            files.Sum(file => file.Bytes),
            files is [var only] ? only.Written : BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(all))));
    }

    /// <summary>SHA-256 of each file.</summary>
    /// <exception cref="BadInputException">One can't be read.</exception>
    public byte[][] Hashes() => OfEach(path => Convert.FromHexString(FileHash.Sha256Of(path)));

    /// <summary>
    /// The checksum of a map: that of its file; of several the SHA-256 of theirs as hexadecimal digits, one after the other.
    /// </summary>
    public static byte[] HashOf(IReadOnlyList<byte[]> hashes) => hashes is [var only]
        ? only
        : SHA256.HashData(Encoding.ASCII.GetBytes(string.Concat(hashes.Select(Convert.ToHexStringLower))));

    private T[] OfEach<T>(Func<string, T> of) => [.. Paths.Select(path => FileErrors.ToBadInput($"{path}: can't be read", () => of(path)))];
}
