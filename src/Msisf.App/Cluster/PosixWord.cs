using System.Buffers;

namespace Msisf.App.Cluster;

/// <summary>Quotes words for a POSIX shell and for the #SBATCH lines of a script, which follow the same rules.</summary>
internal static class PosixWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=,+@%-");

    /// <summary>Quotes a text so that the shell reads it unchanged, whatever characters it contains.</summary>
    public static string Of(string text) =>
        text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain)
            ? text
            : $"'{text.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
