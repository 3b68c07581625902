using Msisf.Adapters.Programs;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Serving;

/// <summary>Starts the program of the server, which msis does not contain: starting ASP.NET Core would slow down every call.</summary>
internal static class ServerProgram
{
    private const string Name = "msis-server";
    private const string Variable = "MSISF_SERVER";
    private const string Folder = "server";

    /// <summary>Runs the server until it ends, or is cancelled.</summary>
    /// <param name="values">The options of msis serve.</param>
    /// <param name="cancellation">Ends the server; it finishes what it is doing.</param>
    /// <param name="onAddress">Gets the address on which it listens; without it the server prints the address itself.</param>
    /// <returns>The server's exit code.</returns>
    /// <exception cref="MsisfException">An option is wrong, or the program is not there.</exception>
    public static async Task<int> RunAsync(
        OptionValues values, ProgramHost host, CancellationToken cancellation, Action<string>? onAddress = null)
    {
        ServeSettings settings = ServeOptions.Read(values); // what is wrong is said by msis, before anything is started
        ChildProgram program = new(Find(host), ServeArguments.ToWords(values, CommandTable.Serve));
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        if (settings.EndsWithInput)
        {
            _ = Starter.GoneAsync(host.StandardInput(), end.Token).ContinueWith(
                _ => end.Cancel(), cancellation, TaskContinuationOptions.None, TaskScheduler.Default);
        }

        return await program.RunUntilInputEndsAsync(end.Token, onAddress).ConfigureAwait(false);
    }

    private static string Find(ProgramHost host)
    {
        string[] names = OperatingSystem.IsWindows() ? [$"{Name}.exe"] : [Name];
        string folder = host.Environment(Variable)
            ?? $"{Path.Combine(AppContext.BaseDirectory, Folder)}{Path.PathSeparator}{AppContext.BaseDirectory}";
        return SearchPath.Find(folder, names) ?? throw new ExternalPartException(
            $"{Name} is not in {folder}, where the server's program belongs. Build it with scripts/build.sh, or set {Variable} to "
                + "its folder.");
    }
}
