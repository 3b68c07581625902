using System.CommandLine;
using Msisf.App.Host;
using Msisf.Cli.Options;
using Msisf.Cli.Options.Config;

namespace Msisf.Cli.Commands;

/// <summary>Says what the configuration files say: <c>msis config show</c>.</summary>
internal static class ConfigCommand
{
    /// <summary>Declares the command.</summary>
    public static Command Create(Configuration configuration, ProgramHost host)
    {
        Command show = new(
            "show", "Prints each option that can stand in a configuration file, its value and where that comes from, separated by tabs.");
        show.SetAction(line =>
        {
            StrayOptions.Refuse(line);
            Show(configuration, line.GetValue(configuration.FileOption), host);
            return 0;
        });
        Command command = new("config", "Works on configuration files.");
        command.Subcommands.Add(show);
        return command;
    }

    private static void Show(Configuration configuration, string? given, ProgramHost host)
    {
        IReadOnlyDictionary<string, ConfigValue> values = configuration.ValuesOf(given);
        if (given is not null)
        {
            host.Log.Note($"{given}: read (--config).");
        }

        host.Log.Note(ConfigFiles.UserFile(host) is { } path
            ? $"{path}: {(ConfigFiles.IsThere(path) ? "read" : "not there")} (the user's file)."
            : "no folder for the user's file: neither XDG_CONFIG_HOME nor HOME is set.");
        foreach (Option option in configuration.Keys.Allowed)
        {
            string key = ConfigKeys.KeyOf(option);
            host.Results.WriteLine(values.TryGetValue(key, out ConfigValue? value)
                ? $"{key}\t{value.Text}\t{value.File}:{value.Line}"
                : $"{key}\t{DefaultText.Of(option)}\tdefault");
        }
    }
}
