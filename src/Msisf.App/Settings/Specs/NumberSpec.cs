using Msisf.Adapters.Input;
using Msisf.Core.Time;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a finite number.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="ValueName">Its unit or meaning, e.g. "DEGREES".</param>
internal sealed record NumberSpec(string Name, OptionRole Role, string ValueName, string Help) : OptionSpec(Name, Role, Help)
{
    public override string ValueName { get; } = ValueName;

    public double? Default { get; init; }

    /// <summary>The accepted range; null if the code that uses the number checks it.</summary>
    public NumberRange? Limits { get; init; }

    public override string? Range => Limits?.ToString();

    public override string? DefaultValue => Default is { } number ? TextOf(number) : null;

    /// <summary>Reads the number, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The value is not a finite number, or it is out of range.</exception>
    public double Read(OptionValues values) => ReadIfGiven(values) ?? Default!.Value;

    /// <summary>Reads the number; null if the option is not given.</summary>
    /// <exception cref="UsageException">The value is not a finite number, or it is out of range.</exception>
    public double? ReadIfGiven(OptionValues values)
    {
        if (values.Text(this) is not string text)
        {
            return null;
        }

        if (!NumberText.TryParse(text, out double number))
        {
            throw new UsageException($"{Name}: {NumberText.ProblemWith(text)}.").About(this);
        }

        return Limits is not { } limits || limits.Contains(number)
            ? number
            : throw new UsageException($"{Name} is {text}; its range is {limits}.").About(this);
    }

    /// <summary>The shortest text that reads back to the same number.</summary>
    public static string TextOf(double number) => number.ToString("R", CultureInfo.InvariantCulture);
}

/// <summary>The range of numbers that an option accepts; the default value of this type accepts only 0.</summary>
/// <param name="Min">Minimum; it lies outside the range if <see cref="ExcludesMin"/>.</param>
/// <param name="Max">Maximum; it lies outside the range if <see cref="ExcludesMax"/>.</param>
internal readonly record struct NumberRange(double Min, double Max)
{
    /// <summary>Whether <see cref="Min"/> itself lies outside the range.</summary>
    public bool ExcludesMin { get; init; }

    /// <summary>Whether <see cref="Max"/> itself lies outside the range.</summary>
    public bool ExcludesMax { get; init; }

    /// <summary>Whether a finite number lies in the range.</summary>
    public bool Contains(double number) =>
        (ExcludesMin ? number > Min : number >= Min) && (ExcludesMax ? number < Max : number <= Max);

    /// <summary>The range as text, e.g. "0 to 100" or "above 0, below 180".</summary>
    public override string ToString()
    {
        string min = Min.ToString("R", CultureInfo.InvariantCulture);
        string max = Max.ToString("R", CultureInfo.InvariantCulture);
        return $"{(ExcludesMin ? $"above {min}, " : $"{min} ")}{(ExcludesMax ? "below" : ExcludesMin ? "up to" : "to")} {max}";
    }
}

/// <summary>
/// An option whose value is a list of numbers in braces, e.g. "{qx,qy,qz,q0}", as one quoted word or as the words into which a shell splits
/// it.
/// </summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Fields">Names of the numbers in their order; a single name for a list of any length. MJD is that of a time.</param>
internal sealed record NumberListSpec(string Name, OptionRole Role, IReadOnlyList<string> Fields, string Help)
    : OptionSpec(Name, Role, Help)
{
    public override string ValueName => Fields is [string only] ? $"{{{only},{only},...}}" : $"{{{string.Join(',', Fields)}}}";

    public override bool TakesSeveralWords => true;

    /// <summary>Reads the numbers in their order, in the units of the command line; null if the option is not given.</summary>
    /// <exception cref="UsageException">The braces are unbalanced, the count is wrong, or a value is not a number.</exception>
    public double[]? Read(OptionValues values) => values.Words(this) is { } words
        ? this.Value(
            () => Fields is [string only] ? StateText.ParseList(Name, words, only) : StateText.ParseNumbers(Name, words, Fields))
        : null;

    /// <summary>Reads times of a list of any length; null if the option is not given.</summary>
    /// <exception cref="UsageException">The braces are unbalanced, or a value is not a time.</exception>
    public CalendarTime[]? ReadTimes(OptionValues values) => values.Words(this) is { } words
        ? this.Value(() => StateText.ParseTimes(Name, words))
        : null;

    /// <summary>Reads a time and the numbers behind it; null if the option is not given.</summary>
    /// <exception cref="UsageException">The braces are unbalanced, the count is wrong, or a value is not a time or number.</exception>
    public (CalendarTime Time, double[] Numbers)? ReadState(OptionValues values) => values.Words(this) is { } words
        ? this.Value(() => StateText.ParseState(Name, words, Fields))
        : null;
}

/// <summary>An option whose value is a whole number.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="ValueName">Its unit or meaning, e.g. "PX".</param>
/// <param name="Min">Minimum.</param>
/// <param name="Max">Maximum; <see cref="int.MaxValue"/> for none.</param>
internal sealed record WholeNumberSpec(string Name, OptionRole Role, string ValueName, int Min, int Max, string Help)
    : OptionSpec(Name, Role, Help)
{
    public override string ValueName { get; } = ValueName;

    public int? Default { get; init; }

    public override string? Range => Max == int.MaxValue ? null : Invariant($"{Min} to {Max}");

    public override string? DefaultValue => Default?.ToString(CultureInfo.InvariantCulture);

    /// <summary>Reads the number, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The value is not a whole number, or it is out of range.</exception>
    public int Read(OptionValues values) => ReadIfGiven(values) ?? Default!.Value;

    /// <summary>Reads the number; null if the option is not given.</summary>
    /// <exception cref="UsageException">The value is not a whole number, or it is out of range.</exception>
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
