namespace Msisf.App.Settings.Specs;

/// <summary>An option without a value; in a configuration file true or false.</summary>
/// <inheritdoc/>
internal sealed record FlagSpec(string Name, string Help) : OptionSpec(Name, Help)
{
    /// <inheritdoc/>
    public override string? ValueName => null;

    /// <summary>Whether it is set.</summary>
    public bool Read(OptionValues values) => values.Text(this) is { } text && text != "false";
}
