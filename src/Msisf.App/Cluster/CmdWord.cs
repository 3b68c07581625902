using System.Buffers;
using Msisf.Core.Errors;

namespace Msisf.App.Cluster;

/// <summary>
/// Words of a Windows batch file. Two readers take them apart: cmd, and the rules by which a program finds its arguments.
/// </summary>
internal static class CmdWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:\\+@-");

    /// <summary>A word in quotes, where it needs any; a percent sign is doubled, and a backslash before the closing quote.</summary>
    /// <exception cref="BadInputException">cmd has no way to pass the text on.</exception>
    public static string Of(string text)
    {
        string inner = Inner(text);
        int backslashes = inner.Length - inner.TrimEnd('\\').Length;
        return text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain) ? text : $"\"{inner}{new string('\\', backslashes)}\"";
    }

    /// <summary>The text for a place between quotes that only cmd itself reads.</summary>
    /// <exception cref="BadInputException">cmd has no way to hold the text.</exception>
    public static string Inner(string text) => text.Contains('"') || text.Any(char.IsControl)
        ? throw new BadInputException(
            $"--format bat: {text.ReplaceLineEndings(" ")} has a quotation mark or a control character in it, "
                + $"which a batch file can't pass on. Choose another name, or another --format.")
        : text.Replace("%", "%%", StringComparison.Ordinal);
}
