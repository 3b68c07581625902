using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Help;
using Msisf.Cli.Parsing;

namespace Msisf.Cli.Commands;

/// <summary><c>msis help</c>: prints the help of the program or of a command.</summary>
internal static class HelpCommand
{
    /// <summary>Runs the command.</summary>
    /// <exception cref="UsageException">There is no such command.</exception>
    public static void Run(CommandCall call)
    {
        string path = call.Values.Argument ?? string.Empty;
        CommandSpec command = HelpWords.Find(path.Split(' ', StringSplitOptions.RemoveEmptyEntries)) ?? throw Unknown(path);
        HelpText.Write(call.Host.Results, path, command);
    }

    private static UsageException Unknown(string path)
    {
        string question = NearestName.Question(
            path.Split(' ')[^1], [.. CommandTable.All.Where(entry => entry.Path.Length > 0).Select(entry => entry.Command.Name)]);
        return new UsageException($"'{path}' is no command{(question.Length > 0 ? question : ".")} msis help lists them.");
    }
}
