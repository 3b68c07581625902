using Msisf.App.Serving;
using Msisf.Cli;
using Msisf.Server.Entry;

// msis serve starts this program again, with a word that makes it the server: one file for both is half as large as two.
return args is [ServerProgram.Word, .. string[] words]
    ? await ServerEntry.RunAsync(words).ConfigureAwait(false)
    : await CommandLineEntry.RunAsync(args, holdsServer: true).ConfigureAwait(false);
