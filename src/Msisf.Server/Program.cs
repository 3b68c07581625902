return await Msisf.Server.Entry.ServerEntry.RunAsync(args).ConfigureAwait(false);
