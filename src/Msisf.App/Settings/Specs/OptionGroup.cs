namespace Msisf.App.Settings.Specs;

/// <summary>Options that the help text shows together.</summary>
/// <param name="Title">Title of the group, e.g. "Light".</param>
/// <param name="Options">Options in the order of the help text, common ones first.</param>
internal sealed record OptionGroup(string Title, IReadOnlyList<OptionSpec> Options)
{
    /// <summary>A sentence below the title that applies to all options of the group; null for none.</summary>
    public string? Note { get; init; }
}
