using System.Security.Cryptography;
using System.Text;

namespace Msisf.Adapters.IO;

/// <summary>Names files of one place in a folder that files of many places share, such as the user's cache.</summary>
internal static class PathKey
{
    /// <summary>16 hexadecimal digits that differ from place to place: the beginning of the SHA-256 of the full path.</summary>
    /// <param name="path">A path, which may be relative to the working folder.</param>
    public static string Of(string path) =>
        Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(Path.GetFullPath(path))).AsSpan(0, 8));
}
