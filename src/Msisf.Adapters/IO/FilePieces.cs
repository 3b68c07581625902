using System.Security.Cryptography;

namespace Msisf.Adapters.IO;

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
