using System.ComponentModel;
using System.Diagnostics;

namespace Msisf.Adapters.Programs;

/// <summary>Starts another program and waits for its end. No shell takes part: arguments reach the program as they are.</summary>
/// <param name="Program">The program's file.</param>
public sealed record ChildProgram(string Program, IReadOnlyList<string> Arguments)
{
    /// <summary>How long a killed program may take to disappear: one that waits for a dead disk never does.</summary>
    private static readonly TimeSpan LongestKill = TimeSpan.FromSeconds(10);

    /// <summary>The folder in which it runs; empty for the current one.</summary>
    public string WorkingFolder { get; init; } = string.Empty;

    /// <summary>Environment variables that it gets beside our own, or in place of them.</summary>
    public IReadOnlyDictionary<string, string> Environment { get; init; } = new Dictionary<string, string>();

    /// <summary>The longest that it may run; null for no limit.</summary>
    public TimeSpan? TimeLimit { get; init; }

    /// <summary>Runs the program with an empty standard input.</summary>
    /// <param name="cancellation">Kills it, with all programs that it started.</param>
    /// <exception cref="ExternalPartException">It can't be started.</exception>
    /// <exception cref="TimeoutException">It ran longer than <see cref="TimeLimit"/> and was killed.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public async Task<ProcessResult> RunAsync(CancellationToken cancellation)
    {
        using Process process = Start(takesOutput: true, takesError: true);
        using CancellationTokenSource limit = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        limit.CancelAfter(TimeLimit ?? Timeout.InfiniteTimeSpan);
        process.StandardInput.Close();
        Task<string> output = process.StandardOutput.ReadToEndAsync(CancellationToken.None);
        Task<string> error = process.StandardError.ReadToEndAsync(CancellationToken.None);
        try
        {
            await Task.WhenAll(process.WaitForExitAsync(limit.Token), output, error).WaitAsync(limit.Token).ConfigureAwait(false);
            return new ProcessResult(process.ExitCode, await output.ConfigureAwait(false), await error.ConfigureAwait(false));
        }
        catch (OperationCanceledException)
        {
            process.Kill(entireProcessTree: true);
            await Task.WhenAny(
                process.WaitForExitAsync(CancellationToken.None), Task.Delay(LongestKill, CancellationToken.None)).ConfigureAwait(false);
            cancellation.ThrowIfCancellationRequested();
            throw new TimeoutException(Invariant($"{Program} was ended after {TimeLimit!.Value.TotalSeconds:R} s"));
        }
    }

    /// <summary>Starts the program and leaves it running.</summary>
    /// <exception cref="ExternalPartException">It can't be started.</exception>
    public void StartBeside() => Start(takesOutput: false, takesError: false).Dispose();

    /// <summary>Runs the program with our own standard output and error.</summary>
    /// <param name="cancellation">Closes its standard input, upon which the program ends by itself.</param>
    /// <param name="onLine">Gets the lines of its standard output, which then is not our own.</param>
    /// <returns>Its exit code.</returns>
    /// <exception cref="ExternalPartException">It can't be started.</exception>
    public async Task<int> RunUntilInputEndsAsync(CancellationToken cancellation, Action<string>? onLine = null)
    {
        using Process process = Start(takesOutput: onLine is not null, takesError: false);
        using CancellationTokenRegistration end = cancellation.Register(process.StandardInput.Close);
        while (onLine is not null && await process.StandardOutput.ReadLineAsync(CancellationToken.None).ConfigureAwait(false) is { } line)
        {
            onLine(line);
        }

        await process.WaitForExitAsync(CancellationToken.None).ConfigureAwait(false);
        return process.ExitCode;
    }

    private Process Start(bool takesOutput, bool takesError)
    {
        ProcessStartInfo start = new(Program, Arguments)
        {
            WorkingDirectory = WorkingFolder,
            RedirectStandardInput = true,
            RedirectStandardOutput = takesOutput,
            RedirectStandardError = takesError,
        };
        foreach ((string name, string value) in Environment)
        {
            start.Environment[name] = value;
        }

        try
        {
            return Process.Start(start)!;
        }
        catch (Win32Exception exception)
        {
            throw new ExternalPartException($"{Program}: can't be started: {exception.Message}", exception);
        }
    }
}

/// <summary>What a program gave when it ended.</summary>
/// <param name="Output">Its standard output.</param>
/// <param name="Error">Its standard error.</param>
public sealed record ProcessResult(int ExitCode, string Output, string Error);

/// <summary>Looks for programs in folders.</summary>
public static class SearchPath
{
    /// <summary>The full path of the first program that is there; null if none is.</summary>
    /// <param name="folders">In the form of the PATH variable; a folder earlier in it goes before.</param>
    /// <param name="names">File names under which the program may be installed; the first goes before the others in each folder.</param>
    public static string? Find(string folders, params string[] names) =>
        (from folder in folders.Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
         from name in names
         let candidate = Path.Combine(folder, name)
         where File.Exists(candidate)
         select Path.GetFullPath(candidate)).FirstOrDefault();
}
