using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>A set of frames that the scripts of <c>msis batchconvert</c> make in pieces.</summary>
internal sealed class ConvertedSet
{
    private const string Output = "frames";

    private readonly TemporaryFolder _folder;
    private readonly string _script;

    /// <summary>Writes the script.</summary>
    /// <param name="folder">Of script, outputs and patterns.</param>
    /// <param name="series">What is made.</param>
    /// <param name="format">As batchconvert takes it.</param>
    /// <param name="pieces">How many.</param>
    public ConvertedSet(TemporaryFolder folder, FrameSeries series, string format, int pieces)
    {
        _folder = folder;
        _script = folder["pieces.sh"];
        Msis.Run(
            folder.Path,
            ["batchconvert", "--format", format, "--pieces", $"{pieces}", "--script", _script, .. series.Arguments(Output)]).Succeeded();
    }

    /// <summary>The frames.</summary>
    public FrameFolder Frames => new(_folder[Output]);

    /// <summary>Exit code of the whole; null while Slurm works on it.</summary>
    public string? Result => File.Exists($"{_script}.result") ? File.ReadAllText($"{_script}.result").Trim() : null;

    /// <summary>Runs the script.</summary>
    public ChildRun Run(IReadOnlyDictionary<string, string>? environment = null)
    {
        using RunningProgram program = RunningProgram.Start("/bin/sh", [_script], _folder.Path, environment: environment);
        return program.End(Msis.Limit);
    }

    /// <summary>What Slurm's jobs have said, for a report.</summary>
    public string Logs() => Directory.Exists($"{_script}.logs")
        ? string.Join(
            " / ",
            Directory.EnumerateFiles($"{_script}.logs").Order(StringComparer.Ordinal).Select(
                log => $"{Path.GetFileName(log)}: {SetJudge.OneLine(File.ReadAllText(log))}").TakeLast(5))
        : "no logs";
}
