using System.Globalization;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings.Config;

/// <summary>A value from a configuration file, as it would stand on the command line.</summary>
/// <param name="Option">The option.</param>
/// <param name="Text">Its value; "true" or "false" of a flag.</param>
/// <param name="File">Where it is from.</param>
/// <param name="Line">The line there.</param>
/// <param name="Rank">1 for the file of <c>--config</c>, 2 for the user's file: the smaller wins.</param>
internal sealed record ConfigValue(OptionSpec Option, string Text, string File, int Line, int Rank)
{
    /// <summary>The same for those who read options.</summary>
    public OptionValue ToOptionValue() => new([Text], string.Create(CultureInfo.InvariantCulture, $"{File}, line {Line}"));
}
