using Msisf.App.Serving;

namespace Msisf.Cli.Commands;

/// <summary><c>msis serve</c>: runs the server until a signal ends it.</summary>
internal static class ServeCommand
{
    /// <summary>Runs the command.</summary>
    public static Task<int> RunAsync(CommandCall call, CancellationToken cancellation) =>
        ServerProgram.RunAsync(call.Values, call.Host, cancellation);
}
