using System.Reflection;

namespace Msisf.Cli.Run;

/// <summary>What the outputs say of the program that made them.</summary>
/// <param name="Version">E.g. "1.0.0".</param>
/// <param name="CommandLine">The arguments as the user gave them, quoted where a shell would need it.</param>
internal sealed record ProgramIdentity(string Version, string CommandLine)
{
    public static ProgramIdentity Of(IReadOnlyList<string> arguments) => new(
        typeof(ProgramIdentity).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion,
        string.Join(' ', arguments.Select(Quoted)));

    private static string Quoted(string argument) =>
        argument.Length > 0 && !argument.Any(character => char.IsWhiteSpace(character) || character is '"' or '\'')
            ? argument
            : $"'{argument.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
