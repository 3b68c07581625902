using Msisf.App.Host;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Commands;

/// <summary>One call of a command.</summary>
/// <param name="Values">Options of the call, including those from configuration files.</param>
/// <param name="Words">All words of the command line, with the words of response files inserted in their places.</param>
/// <param name="Host">The world.</param>
internal sealed record CommandCall(OptionValues Values, IReadOnlyList<string> Words, ProgramHost Host);
