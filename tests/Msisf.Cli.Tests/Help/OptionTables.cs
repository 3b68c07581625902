using System.Globalization;
using System.Text;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Help;

namespace Msisf.Cli.Tests.Help;

/// <summary>The tables of docs/command-line.md, made from the program's table of options.</summary>
internal static class OptionTables
{
    /// <summary>All tables: the groups of a run first, then each command with what is its own.</summary>
    public static string Text()
    {
        StringBuilder page = new();
        Dictionary<string, string> described = [];
        foreach (OptionGroup group in CommandTable.Render.Groups)
        {
            page.Append(CultureInfo.InvariantCulture, $"### {group.Title}\n\n{(group.Note is null ? string.Empty : $"{group.Note}\n\n")}");
            AppendTable(page, group.Options);
        }

        foreach ((string path, CommandSpec command) in CommandTable.All.Where(
            entry => entry.Path.Length > 0 && entry.Command.Commands.Count == 0))
        {
            string call = HelpText.UsageOf(path, command).First().Replace(" [OPTIONS]", string.Empty, StringComparison.Ordinal);
            page.Append(CultureInfo.InvariantCulture, $"### {call}\n\n");
            page.Append(CultureInfo.InvariantCulture, $"{Cell($"{command.Summary} {command.Details}".TrimEnd())}\n\n");
            ILookup<string?, OptionSpec> options = command.Options.Except(CommandTable.Render.Options)
                .ToLookup(option => described.GetValueOrDefault(RowOf(option)));
            AppendTable(page, [.. options[null]]);
            foreach (IGrouping<string?, OptionSpec> repeated in options.Where(group => group.Key is not null))
            {
                string names = string.Join(", ", repeated.Select(option => $"`{option.Name}`"));
                page.Append(CultureInfo.InvariantCulture, $"As for [{repeated.Key}](#{AnchorOf(repeated.Key!)}): {names}.\n\n");
            }

            foreach (OptionSpec option in options[null])
            {
                described.Add(RowOf(option), call);
            }
        }

        return page.ToString();
    }

    /// <summary>GitHub's anchor of a heading.</summary>
    private static string AnchorOf(string heading) =>
        string.Concat(heading.ToLowerInvariant().Where(letter => char.IsLetterOrDigit(letter) || letter is ' ' or '-')).Replace(' ', '-');

    private static void AppendTable(StringBuilder page, IReadOnlyList<OptionSpec> options)
    {
        if (options.Count == 0)
        {
            return;
        }

        page.Append("| option | value | what it does |\n|---|---|---|\n");
        foreach (OptionSpec option in options)
        {
            page.Append(RowOf(option));
        }

        page.Append('\n');
    }

    private static string RowOf(OptionSpec option)
    {
        string names = string.Join(", ", option.Aliases.Prepend(option.Name).Select(name => $"`{name}`"));
        string value = option.ValueName is null ? string.Empty : $"`{option.ValueName}`";
        string notes = option.Notes.Length == 0 ? string.Empty : $" ({option.Notes})";
        return $"| {names} | {Cell(value)} | {Cell(option.Help + notes)} |\n";
    }

    private static string Cell(string text) => text.Replace("|", "\\|", StringComparison.Ordinal);
}
