using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>The program as users have it: what scripts/build.sh published, started by the launcher.</summary>
internal static class Msis
{
    /// <summary>Runs take seconds; one that takes longer hangs.</summary>
    public static readonly TimeSpan Limit = TimeSpan.FromMinutes(5);

    /// <summary>What is missing to run it; null if nothing is.</summary>
    public static string? MissingPart =>
        !OperatingSystem.IsLinux() ? "Linux (/proc)"
        : !File.Exists(Path.Combine(TestParts.RepositoryRoot, "publish", "msis")) ? "the published program (scripts/build.sh)"
        : TestParts.Ldem4Label is null ? "LDEM_4 (msis fetch ldem)"
        : null;

    /// <summary>The launcher, or what MSISF_PROGRAM names; it becomes the program, so that their process is one.</summary>
    public static string Program => TestedProgram.Named ?? Path.Combine(TestParts.RepositoryRoot, "msis");

    /// <summary>Starts it in a folder.</summary>
    public static RunningProgram Start(string folder, IReadOnlyList<string> arguments, Action<string>? onOutput = null) =>
        RunningProgram.Start(Program, arguments, folder, onOutput: onOutput);

    /// <summary>Runs it in a folder to its end.</summary>
    public static ChildRun Run(string folder, IReadOnlyList<string> arguments)
    {
        using RunningProgram program = Start(folder, arguments);
        return program.End(Limit);
    }
}
