using Msisf.App.Host;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Commands;

/// <summary>One call of a command.</summary>
/// <param name="Values">Its options, also those of configuration files.</param>
/// <param name="Words">All words of the command line, those of files of arguments in their places.</param>
/// <param name="Host">The world.</param>
internal sealed record CommandCall(OptionValues Values, IReadOnlyList<string> Words, ProgramHost Host);
