namespace Msisf.App.Settings.Specs;

/// <summary>A command of the program with its argument and options.</summary>
/// <param name="Name">Name of the command; the program's own name for the render command.</param>
/// <param name="Summary">Description of the command: one sentence.</param>
internal sealed record CommandSpec(string Name, string Summary)
{
    private IReadOnlyList<OptionGroup>? _groups;

    /// <summary>Further sentences for the help of the command; null for none.</summary>
    public string? Details { get; init; }

    /// <summary>Makes the positional argument, when it is first needed; null for none.</summary>
    public Func<ArgumentSpec>? MakeArgument { get; init; }

    public ArgumentSpec? Argument => MakeArgument?.Invoke();

    /// <summary>Makes the options, in groups, when they are first needed: a call needs those of one command only.</summary>
    public Func<IReadOnlyList<OptionGroup>> MakeGroups { get; init; } = () => [];

    public IReadOnlyList<OptionGroup> Groups => _groups ??= MakeGroups();

    /// <summary>Subcommands; if there are any, one must be given, except for the program itself.</summary>
    public IReadOnlyList<CommandSpec> Commands { get; init; } = [];

    public IReadOnlyList<(string Meaning, string Call)> Examples { get; init; } = [];

    public IEnumerable<OptionSpec> Options => Groups.SelectMany(group => group.Options);
}

/// <summary>Options that the help text shows together.</summary>
/// <param name="Title">Title of the group, e.g. "Light".</param>
/// <param name="Options">Options in the order of the help text, common ones first.</param>
internal sealed record OptionGroup(string Title, IReadOnlyList<OptionSpec> Options)
{
    /// <summary>A sentence below the title that applies to all options of the group; null for none.</summary>
    public string? Note { get; init; }
}

/// <summary>A positional argument of a command.</summary>
/// <param name="Name">Name in the help text, e.g. "DIR".</param>
/// <param name="Help">Description of the argument: one sentence without a full stop.</param>
internal sealed record ArgumentSpec(string Name, string Help)
{
    /// <summary>Whether the argument may be omitted.</summary>
    public bool IsOptional { get; init; }

    /// <summary>Whether several words may be given, which are joined by blanks.</summary>
    public bool TakesSeveralWords { get; init; }

    /// <summary>The allowed values; empty for a path.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];
}
