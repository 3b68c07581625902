using Msisf.Cli;
using Msisf.Cli.Run;

ProgramHost host = new(Console.Out, Console.Error, () => Console.In, TimeProvider.System, args, Environment.GetEnvironmentVariable);
return await CommandLineProgram.RunAsync(args, host).ConfigureAwait(false);
