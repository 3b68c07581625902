using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary>The script for Slurm, with an sbatch that runs each job at once: who submits what, and how it ends.</summary>
[SupportedOSPlatform("linux")]
public sealed class SlurmScriptTests : IDisposable
{
    private readonly ConvertedScript _converted = new();

    private string Output => _converted.Folder["out"];

    private string Submitted => _converted.Folder["submitted"];

    public void Dispose() => _converted.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_NothingMissing_IsOneArrayOneCheckAndTheMerge()
    {
        string script = Convert("--concurrency", "2", "--contact-sheet", "--video", "25");

        ChildRun run = Run(script);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(["1:3", "4:6", "7:10"], _converted.PieceCalls());
        string[] calls = File.ReadAllLines(_converted.Calls);
        Assert.Equal([$"verify|{Output}|--print-frames|", $"merge|{Output}|--contact-sheet|--video|25|"], calls[3..]);
        Assert.All(calls[..3], call => Assert.Contains("|--jobs|2|", call, StringComparison.Ordinal));
        string[] jobs = File.ReadAllLines(Submitted);
        Assert.StartsWith("--parsable|--array=1-3%2|", jobs[0], StringComparison.Ordinal);
        Assert.Contains("|--dependency=afterany:101|", jobs[1], StringComparison.Ordinal);
        Assert.Equal(2, jobs.Length);
        Assert.Equal("0", File.ReadAllText(script + ".result").TrimEnd());
        Assert.Equal(["101", "102"], File.ReadAllLines(script + ".jobs"));
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_MissingFrames_AreSubmittedAgainInAsManyPiecesAsTheRunHad()
    {
        string script = Convert();

        Run(script, "1,3:5,9:10", "4");

        Assert.Equal(["1:3", "4:6", "7:10", "1,3", "4:5", "9:10", "4"], _converted.PieceCalls());
        Assert.Equal($"merge|{Output}|", File.ReadLines(_converted.Calls).Last());
        Assert.Equal("0", File.ReadAllText(script + ".result").TrimEnd());
        Assert.False(File.Exists(script + ".missing"));
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_StillMissingAfterTheRetries_EndsWithTheListAndCode5()
    {
        string script = Convert("--retries", "1");

        Run(script, "1,3:5", "4", "4");

        Assert.Equal(["1:3", "4:6", "7:10", "1,3", "4:5"], _converted.PieceCalls());
        Assert.Equal("4", File.ReadAllText(script + ".missing").TrimEnd());
        Assert.Equal("5", File.ReadAllText(script + ".result").TrimEnd());
        Assert.Contains("not made after 1 retries: 4", File.ReadAllText(_converted.Folder["log"]), StringComparison.Ordinal);
        Assert.DoesNotContain("merge", File.ReadAllText(_converted.Calls), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_NoPieceEverBegan_SubmitsAllAgain()
    {
        string script = Convert("--retries", "1");

        RunWithoutManifest(script);

        Assert.Equal(["1:3", "4:6", "7:10", "1:4", "5:8", "9:10"], _converted.PieceCalls());
        Assert.Equal("1:3,4:6,7:10", File.ReadAllText(script + ".missing").TrimEnd());
        Assert.Equal("5", File.ReadAllText(script + ".result").TrimEnd());
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_PovRay_MakesThePatternsFirst()
    {
        string script = Convert("--renderer", "povray", "--fov", "10", "--pattern-repos", "my patterns");

        Run(script);

        string first = File.ReadLines(_converted.Calls).First();
        Assert.Equal(
            $"patterns|--for-batch|{script}.states.tab|--fov=10|--ldem={TestParts.Ldem4Label}|--pattern-repos=my "
                + $"patterns|--ephemeris=builtin|",
            first);
        Assert.Contains("|--dependency=afterany:101|", File.ReadAllLines(Submitted)[1], StringComparison.Ordinal);
        Assert.Equal(["1:3", "4:6", "7:10"], _converted.PieceCalls());
    }

    /// <summary>The script has the exposure time that the whole run finds: its pieces make that run's bytes and look for nothing.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_AutomaticExposure_IsFoundOnceForAllPieces()
    {
        string camera = _converted.Folder.Write(
            "camera.yaml",
            "width: 24\nheight: 16\nfocal-length: 5\npixel-pitch: 0.1\ndetector:\n  aperture: 0.2\n  exposure-time: 1\n"
                + "  band: [500, 650]\n  quantum-efficiency: 0.5\n  gain: 10\n  adc-bits: 12\n  fits: no\n");
        string[] options =
            ["--camera", camera, "--exposure-time", "auto", "--noise-seed", "3", "--albedo-map", "none"];
        string script = Convert(options);
        Run(script);
        string[][] pieces = [.. File.ReadAllLines(_converted.Calls).Where(
            call => call.Contains("|--frames|", StringComparison.Ordinal)).Select(call => call.TrimEnd('|').Split('|'))];
        CommandLineRun whole = CommandLineRun.Of(
        [
            "--batch-file", $"{script}.states.tab", "--renderer", "native", "--output-dir", _converted.Folder["whole"], "--batch",
            .. options, .. ConvertedScript.Common,
        ]);
        Assert.True(whole.ExitCode == 0, whole.Error);

        Assert.Equal(3, pieces.Length);
        foreach (string[] piece in pieces)
        {
            CommandLineRun made = CommandLineRun.Of(piece);
            Assert.True(made.ExitCode == 0, made.Error);
            Assert.DoesNotContain("auto", made.Error, StringComparison.Ordinal);
        }

        foreach (string file in Directory.EnumerateFiles(_converted.Folder["whole"], "Moon*"))
        {
            Assert.Equal(File.ReadAllBytes(file), File.ReadAllBytes(Path.Combine(Output, Path.GetFileName(file))));
        }

        Assert.Equal(20, Directory.EnumerateFiles(Output, "Moon*").Count());
    }

    [RequiresFact(Part.Ldem4)]
    public void Convert_Resources_StandInTheHead()
    {
        string script = Convert(
            "--cpus-per-task", "4", "--memory", "2G", "--time-limit", "1-02:00:00", "--partition", "long", "--account", "moon",
            "--sbatch-options", "qos=high exclusive");

        string[] lines = [.. File.ReadLines(script).Where(line => line.StartsWith("#SBATCH", StringComparison.Ordinal))];
        Assert.Equal(
            [
                "#SBATCH --open-mode=append", "#SBATCH --requeue", "#SBATCH --cpus-per-task=4", "#SBATCH --mem=2G",
                "#SBATCH --time=1-02:00:00",
                "#SBATCH --partition=long", "#SBATCH --account=moon", "#SBATCH --qos=high", "#SBATCH --exclusive",
            ],
            lines[2..]);
        Assert.True(Directory.Exists(script + ".logs"));
    }

    [RequiresFact(Part.Ldem4)]
    public void Submit_SbatchThatFails_EndsAtOnceWithCode3()
    {
        string script = Convert();
        string folder = Path.GetDirectoryName(_converted.WriteProgram("broken/sbatch", "echo no controller >&2; exit 1"))!;

        ChildRun run = ChildRun.Of("env", [$"PATH={folder}:/usr/bin:/bin", "sh", script], "/");

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("no controller", run.Error, StringComparison.Ordinal);
    }

    private string Convert(params string[] options) =>
        _converted.Convert("slurm", "M\u00f6nd 'a' 100%/run.sh", ["--pieces", "3", "--output-dir", Output, .. options]);

    /// <summary>Runs the script.</summary>
    /// <param name="script">It.</param>
    /// <param name="missing">What each check finds; then nothing.</param>
    private ChildRun Run(string script, params string[] missing)
    {
        _converted.Folder.Write("out/msisf-manifest.jsonl", string.Empty);
        return RunWithoutManifest(script, missing);
    }

    private ChildRun RunWithoutManifest(string script, params string[] missing)
    {
        string left = _converted.Folder["missing"];
        File.WriteAllLines(left, missing);
        string fake = _converted.FakeMsis(
            $"[ \"$1\" = verify ] || exit 0\nmissing=$(head -n 1 '{left}')\nsed -i 1d '{left}'\nprintf '%s\\n' \"$missing\"\n[ -z "
                + $"\"$missing\" ] || exit 5");
        string folder = Path.GetDirectoryName(_converted.WriteProgram("bin/sbatch", $$"""
            line=$(printf '%s|' "$@")
            printf '%s\n' "$line" >>'{{Submitted}}'
            id=$((100 + $(wc -l <'{{Submitted}}')))
            tasks=1
            while :; do
                case $1 in
                    --array=*) tasks=${1#--array=1-} tasks=${tasks%\%*} ;;
                    --*) ;;
                    *) break ;;
                esac
                shift
            done
            task=0
            while [ "$task" -lt "$tasks" ]; do
                task=$((task + 1))
                SLURM_JOB_ID=$id SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=2 sh "$@" >>'{{_converted.Folder["log"]}}' 2>&1
            done
            echo "$id;cluster"
            """))!;
        return ChildRun.Of("env", [$"MSIS={fake}", $"PATH={folder}:/usr/bin:/bin", "sh", script], "/");
    }
}
