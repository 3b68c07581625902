using System.Security.Cryptography;

namespace Msisf.Adapters.IO;

/// <summary>Checksums of files, as the manifest has them.</summary>
public static class FileHash
{
    /// <summary>SHA-256 of a file's content: 64 hexadecimal digits in small letters.</summary>
    /// <exception cref="IOException">It can't be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It can't be read.</exception>
    public static string Sha256Of(string path)
    {
        using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        return Convert.ToHexStringLower(SHA256.HashData(stream));
    }
}
