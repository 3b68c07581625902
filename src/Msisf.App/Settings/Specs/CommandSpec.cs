namespace Msisf.App.Settings.Specs;

/// <summary>One command of the program, and what can be given to it.</summary>
/// <param name="Name">As it is called; the program's own name for the render command.</param>
/// <param name="Summary">What it does: one sentence.</param>
internal sealed record CommandSpec(string Name, string Summary)
{
    /// <summary>More sentences for the command's own help; null for none.</summary>
    public string? Details { get; init; }

    /// <summary>The argument that is no option; null for none.</summary>
    public ArgumentSpec? Argument { get; init; }

    /// <summary>The options, in groups.</summary>
    public IReadOnlyList<OptionGroup> Groups { get; init; } = [];

    /// <summary>Commands below this one; if there are any and this is not the program itself, one of them must be called.</summary>
    public IReadOnlyList<CommandSpec> Commands { get; init; } = [];

    /// <summary>Calls that show the use, each with what it does.</summary>
    public IReadOnlyList<(string Meaning, string Call)> Examples { get; init; } = [];

    /// <summary>All options of the command.</summary>
    public IEnumerable<OptionSpec> Options => Groups.SelectMany(group => group.Options);
}
