using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>
/// An option whose value is a list of numbers in braces, e.g. "{qx,qy,qz,q0}", as one quoted word or as the words into which a shell splits
/// it.
/// </summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Role">What the option decides.</param>
/// <param name="Fields">Names of the numbers in their order; a single name for a list of any length.</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
internal sealed record NumberListSpec(string Name, OptionRole Role, IReadOnlyList<string> Fields, string Help)
    : OptionSpec(Name, Role, Help)
{
    /// <inheritdoc/>
    public override string ValueName => Fields is [string only] ? $"{{{only},{only},...}}" : $"{{{string.Join(',', Fields)}}}";

    /// <inheritdoc/>
    public override bool TakesSeveralWords => true;

    /// <summary>Reads the numbers in their order, in the units of the command line; null if the option is not given.</summary>
    /// <exception cref="UsageException">The braces are unbalanced, the count is wrong, or a value is no number.</exception>
    public double[]? Read(OptionValues values) => values.Words(this) is { } words
        ? this.Value(
            () => Fields is [string only] ? StateText.ParseList(Name, words, only) : StateText.ParseNumbers(Name, words, Fields))
        : null;
}
