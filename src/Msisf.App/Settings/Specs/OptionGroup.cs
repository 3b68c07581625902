namespace Msisf.App.Settings.Specs;

/// <summary>Options that stand together in help.</summary>
/// <param name="Title">Above them, e.g. "Light".</param>
/// <param name="Options">In the order of help, the common ones first.</param>
internal sealed record OptionGroup(string Title, IReadOnlyList<OptionSpec> Options)
{
    /// <summary>A sentence under the title that holds for all of them; null for none.</summary>
    public string? Note { get; init; }
}
