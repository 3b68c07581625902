namespace Msisf.Cli.Commands;

/// <summary>What a command does.</summary>
/// <param name="call">Its options.</param>
/// <param name="cancellation">Ends it, as Ctrl-C does.</param>
/// <returns>The exit code.</returns>
internal delegate Task<int> CommandAction(CommandCall call, CancellationToken cancellation);
