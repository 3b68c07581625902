using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is several numbers in braces, e.g. "{qx,qy,qz,q0}", quoted or taken apart by the shell.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Fields">The numbers' names in their order; a single one for a list of any length.</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
internal sealed record NumberListSpec(string Name, IReadOnlyList<string> Fields, string Help) : OptionSpec(Name, Help)
{
    /// <inheritdoc/>
    public override string ValueName => Fields is [string only] ? $"{{{only},{only},...}}" : $"{{{string.Join(',', Fields)}}}";

    /// <inheritdoc/>
    public override bool TakesSeveralWords => true;

    /// <summary>The numbers, in their order and in the units that were typed; null if they are not given.</summary>
    /// <exception cref="BadInputException">Unbalanced braces, a wrong count, or no numbers.</exception>
    public double[]? Read(OptionValues values) => values.Words(this) is { } words
        ? this.Concerned(
            () => Fields is [string only] ? StateText.ParseList(Name, words, only) : StateText.ParseNumbers(Name, words, Fields))
        : null;
}
