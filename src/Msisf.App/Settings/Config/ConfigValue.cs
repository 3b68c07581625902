using System.Globalization;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings.Config;

/// <summary>A value from a configuration file, as it would be typed on the command line.</summary>
/// <param name="Option">The option.</param>
/// <param name="Text">Value of the option; "true" or "false" for a flag.</param>
/// <param name="File">Path of the file.</param>
/// <param name="Line">Line number in the file.</param>
/// <param name="Rank">1 for the file of <c>--config</c>, 2 for the user's file; the smaller rank takes precedence.</param>
internal sealed record ConfigValue(OptionSpec Option, string Text, string File, int Line, int Rank)
{
    /// <summary>Converts the value to the form in which options are read.</summary>
    public OptionValue ToOptionValue() => new(
        Option is PathSpec { TakesSeveral: true } ? Text.Split(PathSpec.Separator) : [Text],
        string.Create(CultureInfo.InvariantCulture, $"{File}, line {Line}"));
}
