namespace Msisf.App.Settings.Specs;

/// <summary>
/// A setting that a user can give as a command-line option or as a key in a configuration file. Parsing, help, completion, the manual page,
/// configuration keys, a frame's canonical arguments and the tables in docs are all made from these objects.
/// </summary>
/// <param name="Name">Long name with its dashes, e.g. "--fov".</param>
/// <param name="Help">
/// Description of the option: one sentence without a full stop. Choices, range and default are not included; they are added to it.
/// </param>
internal abstract record OptionSpec(string Name, OptionRole Role, string Help)
{
    /// <summary>Other names, e.g. "-f".</summary>
    public IReadOnlyList<string> Aliases { get; init; } = [];

    /// <summary>The value in the help text: its meaning or unit, e.g. "DEGREES", or its choices; null for a flag.</summary>
    public abstract string? ValueName { get; }

    /// <summary>Whether the value may be several command-line words, because a shell can split braces into words.</summary>
    public virtual bool TakesSeveralWords => false;

    /// <summary>Whether the option may be given several times, with one value each.</summary>
    public virtual bool MayBeRepeated => false;

    /// <summary>Values that shell completion offers; other values may be possible.</summary>
    public virtual IReadOnlyList<string> Suggestions => [];

    /// <summary>
    /// Separator of the list's values when a configuration file gives them separately; null if the option takes one value.
    /// </summary>
    public virtual string? ListSeparator => null;

    /// <summary>The range of a number as text, e.g. "1 to 16384"; null if the help text should not show one.</summary>
    public virtual string? Range => null;

    /// <summary>The default as it would be typed on the command line; null if there is none.</summary>
    public virtual string? DefaultValue => null;

    /// <summary>Description of the default that replaces or explains <see cref="DefaultValue"/>; null if none is needed.</summary>
    public string? DefaultNote { get; init; }

    /// <summary>Whether the option must be given.</summary>
    public bool IsRequired { get; init; }

    /// <summary>Whether the option applies to one call only and so is not allowed in a configuration file.</summary>
    public bool IsOfOneCall { get; init; }

    /// <summary>A value as it is compared with others: a word of a choice in the case in which the help text has it.</summary>
    public virtual string Canonical(string text) => text;

    /// <summary>A value of the option as it would be typed on the command line.</summary>
    public virtual string TextOf(object value) =>
        value is double number ? NumberSpec.TextOf(number) : Convert.ToString(value, CultureInfo.InvariantCulture)!;

    /// <summary>Key in a configuration file: the long name without its dashes.</summary>
    public string Key => Name[2..];

    /// <summary>
    /// Range and default that follow the description in the help text, e.g. "1 to 16384; default: 1024"; empty if there is neither.
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

/// <summary>An option without a value on the command line; in a configuration file its value is true or false.</summary>
/// <inheritdoc/>
internal sealed record FlagSpec(string Name, OptionRole Role, string Help) : OptionSpec(Name, Role, Help)
{
    public override string? ValueName => null;

    /// <summary>Reads whether the flag is set.</summary>
    public bool Read(OptionValues values) => values.Text(this) is { } text && text != "false";
}

/// <summary>
/// What an option decides: the bytes of the outputs (<see cref="DecidesBytes"/>), where and how they are made, or what is printed.
/// </summary>
internal class OptionRole
{
    /// <summary>Where and how the outputs are made; their bytes are the same with any value.</summary>
    public static readonly OptionRole HowItRuns = new();

    /// <summary>What is printed or measured; the outputs are the same.</summary>
    public static readonly OptionRole WhatIsPrinted = new();

    protected OptionRole()
    {
    }
}
