using System.CommandLine.Parsing;
using Msisf.Core.Errors;

namespace Msisf.Cli.Parsing;

/// <summary>
/// Reads <c>@file</c>: the arguments in a file, one or more a line, quoted with '"' where they hold blanks; '#' begins a comment line.
/// A file of arguments names no other: System.CommandLine's own reader runs out of stack on one that names itself.
/// </summary>
internal static class ResponseFile
{
    /// <summary>As <see cref="System.CommandLine.Parsing.TryReplaceToken"/> has it.</summary>
    /// <param name="path">What stands behind the '@'.</param>
    /// <param name="arguments">The arguments in the file.</param>
    /// <param name="error">What is wrong with it.</param>
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
                    $"@{path} holds a NUL character: it is no text file",
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
