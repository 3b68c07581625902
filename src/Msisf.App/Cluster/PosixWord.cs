using System.Buffers;

namespace Msisf.App.Cluster;

/// <summary>Words of a POSIX shell, and of sbatch's lines in a script, which are read the same way.</summary>
internal static class PosixWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=,+@%-");

    /// <summary>A word that the shell takes as it is, whatever characters are in it.</summary>
    public static string Of(string text) =>
        text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain)
            ? text
            : $"'{text.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
