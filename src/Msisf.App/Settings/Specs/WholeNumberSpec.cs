namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a whole number.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="ValueName">Its unit or meaning, e.g. "PX".</param>
/// <param name="Min">Minimum.</param>
/// <param name="Max">Maximum; <see cref="int.MaxValue"/> for none.</param>
internal sealed record WholeNumberSpec(string Name, OptionRole Role, string ValueName, int Min, int Max, string Help)
    : OptionSpec(Name, Role, Help)
{
    public override string ValueName { get; } = ValueName;

    /// <summary>The default; null if there is none.</summary>
    public int? Default { get; init; }

    public override string? Range => Max == int.MaxValue ? null : Invariant($"{Min} to {Max}");

    public override string? DefaultValue => Default?.ToString(CultureInfo.InvariantCulture);

    /// <summary>Reads the number, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The value is no whole number, or it is out of range.</exception>
    public int Read(OptionValues values) => ReadIfGiven(values) ?? Default!.Value;

    /// <summary>Reads the number; null if the option is not given.</summary>
    /// <exception cref="UsageException">The value is no whole number, or it is out of range.</exception>
    public int? ReadIfGiven(OptionValues values)
    {
        if (values.Text(this) is not string text)
        {
            return null;
        }

        return int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int number) && number >= Min
            && number <= Max
            ? number
            : throw new UsageException(Invariant($"{Name} is '{text}'; a whole number from {Min} to {Max} is needed.")).About(this);
    }
}
