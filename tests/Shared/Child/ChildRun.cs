namespace Msisf.TestSupport;

/// <summary>One run of another program, and what came of it.</summary>
internal sealed record ChildRun(int ExitCode, string Output, string Error)
{
    /// <summary>Far above what any program here takes, even on a busy machine.</summary>
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(10);

    /// <summary>Runs a program to its end.</summary>
    /// <param name="program">Its file.</param>
    /// <param name="arguments">As its <c>main</c> gets them.</param>
    /// <param name="folder">Its working directory.</param>
    /// <param name="standardInput">What stands on its standard input.</param>
    /// <param name="environment">Variables that it gets beside this process's own.</param>
    /// <exception cref="TimeoutException">It did not end in time, and was killed; the message has what it said.</exception>
    public static ChildRun Of(
        string program,
        IReadOnlyList<string> arguments,
        string folder,
        string standardInput = "",
        IReadOnlyDictionary<string, string>? environment = null)
    {
        using RunningProgram running = RunningProgram.Start(program, arguments, folder, standardInput, environment);
        return running.End(Limit);
    }

    /// <summary>This run, if it went well.</summary>
    /// <exception cref="InvalidOperationException">It did not; the message has what the program said.</exception>
    public ChildRun Succeeded() =>
        ExitCode == 0 ? this : throw new InvalidOperationException($"exit code {ExitCode}: {Error}{Output}");
}
