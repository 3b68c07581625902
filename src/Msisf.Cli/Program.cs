return await Msisf.Cli.CommandLineEntry.RunAsync(args, holdsServer: false).ConfigureAwait(false);
