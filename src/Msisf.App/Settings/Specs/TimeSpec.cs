using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Msisf.Core.Time;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a time: an MJD (UTC), or ISO 8601.</summary>
/// <inheritdoc/>
internal sealed record TimeSpec(string Name, OptionRole Role, string Help) : OptionSpec(Name, Role, Help)
{
    /// <inheritdoc/>
    public override string ValueName => "TIME";

    /// <summary>Reads the time, which must be given.</summary>
    /// <exception cref="BadInputException">The value is no time.</exception>
    public ModifiedJulianDate Read(OptionValues values) => this.Named(() => TimeText.Parse(values.Text(this)!));
}
