using System.Buffers;
using System.Security.Cryptography;
using System.Text;

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

/// <summary>A checksum of a large file that tells files apart without reading them completely: of pieces spread over the file.</summary>
internal static class FilePieces
{
    /// <summary>Pieces that are read, from the file's start to its end.</summary>
    private const int Pieces = 64;

    private const int PieceBytes = 4096;

    /// <summary>SHA-256 of a file's length (8 bytes, little-endian) and of its pieces: 64 hexadecimal digits in small letters.</summary>
    /// <exception cref="IOException">It can't be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It can't be read.</exception>
    public static string Sha256Of(Stream file)
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Append(hash, file);
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    /// <summary>Adds a file's length and pieces to a checksum.</summary>
    public static void Append(IncrementalHash hash, Stream file)
    {
        hash.AppendData(BitConverter.GetBytes(file.Length));
        long last = Math.Max(0, file.Length - PieceBytes);
        for (int piece = 0; piece < Pieces; piece++)
        {
            Append(hash, file, last * piece / (Pieces - 1), Math.Min(PieceBytes, file.Length));
        }
    }

    /// <summary>Adds one piece of a file to a checksum.</summary>
    public static void Append(IncrementalHash hash, Stream file, long start, long length)
    {
        byte[] piece = new byte[length];
        file.Position = start;
        file.ReadExactly(piece);
        hash.AppendData(piece);
    }
}

/// <summary>Names files of one place in a folder that files of many places share, such as the user's cache.</summary>
internal static class PathKey
{
    /// <summary>16 hexadecimal digits that differ from place to place: the beginning of the SHA-256 of the full path.</summary>
    /// <param name="path">A path, which may be relative to the working folder.</param>
    public static string Of(string path) =>
        Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(Path.GetFullPath(path))).AsSpan(0, 8));
}
