using System.CommandLine.Parsing;

namespace Msisf.Cli.Parsing;

/// <summary>
/// Reads the arguments of <c>@file</c> from a file: one or more per line, quoted with '"' if they contain blanks; '#' begins a comment
/// line. Response files can't be nested: System.CommandLine's own reader overflows the stack if a file names itself.
/// </summary>
internal static class ResponseFile
{
    /// <summary>Reads a response file; the signature is that of <see cref="System.CommandLine.Parsing.TryReplaceToken"/>.</summary>
    /// <param name="path">Text after the '@'.</param>
    /// <param name="error">Error message.</param>
    public static bool TryRead(string path, out IReadOnlyList<string>? arguments, out string? error)
    {
        (arguments, error) = (null, null);
        try
        {
            arguments = [.. File.ReadLines(path)
                .Where(line => !line.TrimStart().StartsWith('#'))
                .SelectMany(CommandLineParser.SplitCommandLine)];
            error = arguments switch
            {
                _ when arguments.Any(argument => argument.Contains('\0', StringComparison.Ordinal)) =>
                    $"@{path} holds a NUL character: it is not a text file",
                _ when arguments.FirstOrDefault(argument => argument.StartsWith('@')) is string other =>
                    $"@{path} holds '{other}': a file of arguments can't name another one",
                _ => null,
            };
            return error is null;
        }
        catch (Exception exception) when (exception.IsFileError() || exception is ArgumentException)
        {
            error = $"@{path}: the file of arguments can't be read: {exception.Message}";
            return false;
        }
    }
}
