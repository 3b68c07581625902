using Msisf.Adapters.Interop;
using Msisf.Adapters.Programs;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Serving;

/// <summary>
/// Starts the program of the server. On .NET it is one of its own: starting ASP.NET Core would slow down every call of msis.
/// </summary>
internal static class ServerProgram
{
    /// <summary>First argument that makes a program the server that holds it.</summary>
    public const string Word = Name;

    private const string Name = "msis-server";
    private const string Variable = "MSISF_SERVER";
    private const string Folder = "server";
    private const string DotnetProgram = "dotnet";

    /// <summary>Runs the server until it ends, or is cancelled.</summary>
    /// <param name="cancellation">Ends the server; it finishes what it is doing.</param>
    /// <param name="onAddress">Gets the address on which it listens; without it the server prints the address itself.</param>
    /// <returns>The server's exit code.</returns>
    /// <exception cref="MsisfException">An option is wrong, or the program is not there.</exception>
    public static async Task<int> RunAsync(
        OptionValues values, ProgramHost host, CancellationToken cancellation, Action<string>? onAddress = null)
    {
        ServeSettings settings = ServeOptions.Read(values); // what is wrong is said by msis, before anything is started
        ChildProgram program = Of(host, ServeArguments.ToWords(values));
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        if (settings.EndsWithInput)
        {
            _ = Starter.GoneAsync(host.StandardInput(), end.Token).ContinueWith(
                _ => end.Cancel(), cancellation, TaskContinuationOptions.None, TaskScheduler.Default);
        }

        return await program.RunUntilInputEndsAsync(end.Token, onAddress).ConfigureAwait(false);
    }

    private static ChildProgram Of(ProgramHost host, IReadOnlyList<string> words) =>
        host.HoldsServer && host.Environment(Variable) is null
            ? ThisOne([Word, .. words])
            : new ChildProgram(Find(host), words);

    /// <summary>As a .NET tool the program may be one that .NET's own program runs, which is named first then.</summary>
    private static ChildProgram ThisOne(IReadOnlyList<string> words)
    {
        string started = Environment.ProcessPath!;
        return Path.GetFileNameWithoutExtension(started) == DotnetProgram
            ? new ChildProgram(started, [Environment.GetCommandLineArgs()[0], .. words])
            : new ChildProgram(started, words);
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

/// <summary>The user's browser, started by what the system has for it.</summary>
internal sealed class Browser(ProgramHost host)
{
    private static readonly string[] Displays = ["DISPLAY", "WAYLAND_DISPLAY"];

    /// <summary>Opens a page; a note says so where there is no browser to be opened.</summary>
    public void Open(string address)
    {
        if (Opener() is not { } opener)
        {
            host.Log.Note($"Open {address} in a browser.");
            return;
        }

        try
        {
            (opener with { Arguments = [.. opener.Arguments, address] }).StartBeside();
        }
        catch (ExternalPartException exception)
        {
            host.Log.Note($"{exception.Message} Open {address} in a browser.");
        }
    }

    private ChildProgram? Opener()
    {
        if (OperatingSystem.IsWindows())
        {
            return new ChildProgram("explorer", []);
        }

        string name = OperatingSystem.IsMacOS() ? "open" : "xdg-open";
        bool hasScreen = OperatingSystem.IsMacOS() || Displays.Any(display => host.Environment(display) is not null);
        return hasScreen && SearchPath.Find(host.Environment("PATH") ?? string.Empty, name) is { } program
            ? new ChildProgram(program, [])
            : null;
    }
}

/// <summary>Notices that a program has gone that started this one and holds its standard input.</summary>
internal static class Starter
{
    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(500);

    /// <param name="input">Standard input; what is there is not used.</param>
    public static Task InputEndedAsync(TextReader input)
    {
        TaskCompletionSource end = new(TaskCreationOptions.RunContinuationsAsynchronously);
        Thread reading = new(() =>
        {
            while (input.Read() >= 0)
            {
            }

            end.TrySetResult();
        })
        {
            IsBackground = true,
        };
        reading.Start();
        return end.Task;
    }

    /// <summary>
    /// Ends when the program that started this one is gone: its pipe to standard input ends, or it dies while others that it started keep
    /// the pipe open.
    /// </summary>
    public static async Task GoneAsync(TextReader input, CancellationToken cancellation)
    {
        int parent = ParentProcess.Id;
        Task end = InputEndedAsync(input);
        while (!end.IsCompleted && ParentProcess.Id == parent && !cancellation.IsCancellationRequested)
        {
            await Task.WhenAny(end, Task.Delay(BetweenLooks, cancellation)).ConfigureAwait(false);
        }
    }
}
