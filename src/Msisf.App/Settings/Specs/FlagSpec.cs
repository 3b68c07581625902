namespace Msisf.App.Settings.Specs;

/// <summary>An option without a value on the command line; in a configuration file its value is true or false.</summary>
/// <inheritdoc/>
internal sealed record FlagSpec(string Name, OptionRole Role, string Help) : OptionSpec(Name, Role, Help)
{
    /// <inheritdoc/>
    public override string? ValueName => null;

    /// <summary>Reads whether the flag is set.</summary>
    public bool Read(OptionValues values) => values.Text(this) is { } text && text != "false";
}
