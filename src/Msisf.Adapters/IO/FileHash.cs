using System.Buffers;
using System.Security.Cryptography;

namespace Msisf.Adapters.IO;

/// <summary>Checksums of files, as the manifest and the meta files have them.</summary>
public static class FileHash
{
    /// <summary>Bytes read at once: large enough that the hash, not the calls of the system, takes the time.</summary>
    private const int ChunkBytes = 1 << 18;

    /// <summary>SHA-256 of a file's content: 64 hexadecimal digits in small letters.</summary>
    /// <param name="cancellation">Stops between two pieces of it.</param>
    /// <exception cref="IOException">It can't be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It can't be read.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static string Sha256Of(string path, CancellationToken cancellation = default)
    {
        using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        byte[] chunk = ArrayPool<byte>.Shared.Rent(ChunkBytes);
        for (int read = stream.Read(chunk); read > 0; read = stream.Read(chunk))
        {
            cancellation.ThrowIfCancellationRequested();
            hash.AppendData(chunk, 0, read);
        }

        ArrayPool<byte>.Shared.Return(chunk);
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }
}
