namespace Msisf.App.Settings.Specs;

/// <summary>
/// One setting that a user can give: an option on the command line, and a key in a configuration file. Everything else that knows about
/// options is made from these: parsing, help, completion, manual page, configuration keys, a frame's canonical arguments, the tables in
/// docs.
/// </summary>
/// <param name="Name">Long name with its dashes, e.g. "--fov".</param>
/// <param name="Help">
/// What it does: one sentence without a full stop, and without choices, range and default, which are added to it.
/// </param>
internal abstract record OptionSpec(string Name, string Help)
{
    /// <summary>Other names, e.g. "-f".</summary>
    public IReadOnlyList<string> Aliases { get; init; } = [];

    /// <summary>How help shows the value: what it is or its unit, e.g. "DEGREES", or its choices; null for a flag.</summary>
    public abstract string? ValueName { get; }

    /// <summary>Whether the value may be several words of the command line, as a shell makes them of braces.</summary>
    public virtual bool TakesSeveralWords => false;

    /// <summary>Values that a shell can offer; not always all that are possible.</summary>
    public virtual IReadOnlyList<string> Suggestions => [];

    /// <summary>What stands between the values of a list in a configuration file; null if the option takes one value.</summary>
    public virtual string? ListSeparator => null;

    /// <summary>The range of a number in words, e.g. "1 to 16384"; null if there is none that help should show.</summary>
    public virtual string? Range => null;

    /// <summary>The default as it would stand on the command line; null if there is none.</summary>
    public virtual string? DefaultValue => null;

    /// <summary>What the default is in words, in place of or to explain <see cref="DefaultValue"/>; null if that says it all.</summary>
    public string? DefaultNote { get; init; }

    /// <summary>Whether the option must be given.</summary>
    public bool IsRequired { get; init; }

    /// <summary>Whether the option has a meaning for one call only, and so can't stand in a configuration file.</summary>
    public bool IsOfOneCall { get; init; }

    /// <summary>Key in a configuration file: the long name without its dashes.</summary>
    public string Key => Name[2..];

    /// <summary>
    /// What follows the sentence in help: range and default, e.g. "1 to 16384; default: 1024"; empty if there is neither.
    /// </summary>
    public string Notes => string.Join("; ", NoteParts());

    private IEnumerable<string> NoteParts()
    {
        if (IsRequired)
        {
            yield return "required";
        }

        if (Range is not null)
        {
            yield return Range;
        }

        if (DefaultNote is not null || DefaultValue is not null)
        {
            yield return $"default: {DefaultNote ?? DefaultValue}";
        }
    }
}
