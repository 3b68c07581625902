using System.Runtime.InteropServices;
using Msisf.App.Host;
using Msisf.Cli.Output;

namespace Msisf.Cli;

/// <summary>The command line on the console of its process.</summary>
internal static class CommandLineEntry
{
    /// <summary>Runs it.</summary>
    /// <param name="arguments">Arguments as passed to <c>main</c>.</param>
    /// <param name="holdsServer">Whether this program is that of the server too.</param>
    /// <returns>The exit code.</returns>
    public static async Task<int> RunAsync(string[] arguments, bool holdsServer)
    {
        // System.CommandLine converts SIGINT and SIGTERM to a cancellation; SIGHUP, sent when the terminal closes, is handled here.
        using CancellationTokenSource hangUp = new();
        using PosixSignalRegistration registration = PosixSignalRegistration.Create(PosixSignal.SIGHUP, context =>
        {
            context.Cancel = true;
            hangUp.Cancel();
        });
        ProgramHost host = ConsoleHost.Create(
            Console.Out, Console.Error, () => Console.In, TimeProvider.System, Environment.GetEnvironmentVariable, holdsServer);
        return await CommandLineProgram.RunAsync(arguments, host, hangUp.Token).ConfigureAwait(false);
    }
}
