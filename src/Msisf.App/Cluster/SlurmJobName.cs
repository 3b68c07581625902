using System.Security.Cryptography;
using System.Text;

namespace Msisf.App.Cluster;

/// <summary>
/// The name of a script's jobs: all jobs of a script share it and other scripts have other names, so that squeue can select them.
/// </summary>
internal static class SlurmJobName
{
    /// <summary>"msis-" and eight digits of the path's checksum.</summary>
    /// <param name="scriptPath">Full path.</param>
    public static string Of(string scriptPath) =>
        $"msis-{Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(scriptPath)))[..8]}";
}
