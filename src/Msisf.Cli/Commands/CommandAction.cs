namespace Msisf.Cli.Commands;

/// <summary>The action of a command.</summary>
/// <param name="call">Options of the call.</param>
/// <param name="cancellation">Cancels the work, as Ctrl-C does.</param>
/// <returns>The exit code.</returns>
internal delegate Task<int> CommandAction(CommandCall call, CancellationToken cancellation);
