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

/// <summary>Quotes words for a Windows batch file, which both cmd and the called program's own argument parser take apart.</summary>
internal static class CmdWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:\\+@-");

    /// <summary>Quotes a word if needed, doubling percent signs and a backslash before the closing quote.</summary>
    /// <exception cref="UsageException">cmd can't pass this text to a program.</exception>
    public static string Of(string text)
    {
        string inner = Inner(text);
        int backslashes = inner.Length - inner.TrimEnd('\\').Length;
        return text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain) ? text : $"\"{inner}{new string('\\', backslashes)}\"";
    }

    /// <summary>The text for a place between quotes that only cmd reads.</summary>
    /// <exception cref="UsageException">cmd can't hold this text.</exception>
    public static string Inner(string text) => text.Contains('"') || text.Any(char.IsControl)
        ? throw new UsageException(
            $"--format bat: {text.ReplaceLineEndings(" ")} has a quotation mark or a control character in it, "
                + $"which a batch file can't pass on. Choose another name, or another --format.")
        : text.Replace("%", "%%", StringComparison.Ordinal);
}
