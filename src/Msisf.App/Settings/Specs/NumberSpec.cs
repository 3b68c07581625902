using System.Globalization;
using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a finite number.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="ValueName">Its unit or meaning, e.g. "DEGREES".</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
internal sealed record NumberSpec(string Name, string ValueName, string Help) : OptionSpec(Name, Help)
{
    /// <inheritdoc/>
    public override string ValueName { get; } = ValueName;

    /// <summary>The default; null if there is none.</summary>
    public double? Default { get; init; }

    /// <summary>The accepted range; null if the code that uses the number checks it.</summary>
    public NumberRange? Limits { get; init; }

    /// <inheritdoc/>
    public override string? Range => Limits?.ToString();

    /// <inheritdoc/>
    public override string? DefaultValue => Default is { } number ? TextOf(number) : null;

    /// <summary>Reads the number, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The value is no finite number, or it is out of range.</exception>
    public double Read(OptionValues values) => ReadIfGiven(values) ?? Default!.Value;

    /// <summary>Reads the number; null if the option is not given.</summary>
    /// <exception cref="UsageException">The value is no finite number, or it is out of range.</exception>
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
