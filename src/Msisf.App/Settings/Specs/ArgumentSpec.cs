namespace Msisf.App.Settings.Specs;

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
