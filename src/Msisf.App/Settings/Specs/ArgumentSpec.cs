namespace Msisf.App.Settings.Specs;

/// <summary>An argument of a command that is no option.</summary>
/// <param name="Name">As help shows it, e.g. "DIR".</param>
/// <param name="Help">What it is: one sentence without a full stop.</param>
internal sealed record ArgumentSpec(string Name, string Help)
{
    /// <summary>Whether it may be left out.</summary>
    public bool IsOptional { get; init; }

    /// <summary>The only words that it can be; none for a path.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];
}
