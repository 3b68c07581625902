using System.Runtime.InteropServices;
using Msisf.App.Host;
using Msisf.Cli;
using Msisf.Cli.Output;

// System.CommandLine converts SIGINT and SIGTERM to a cancellation; SIGHUP, sent when the terminal closes, is handled here.
using CancellationTokenSource hangUp = new();
using PosixSignalRegistration registration = PosixSignalRegistration.Create(PosixSignal.SIGHUP, context =>
{
    context.Cancel = true;
    hangUp.Cancel();
});
ProgramHost host = ConsoleHost.Create(
    Console.Out, Console.Error, () => Console.In, TimeProvider.System, Environment.GetEnvironmentVariable);
return await CommandLineProgram.RunAsync(args, host, hangUp.Token).ConfigureAwait(false);
