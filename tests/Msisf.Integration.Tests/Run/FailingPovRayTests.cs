using Msisf.App.Host;
using Msisf.Cli.Output;
using Msisf.TestSupport;
using Xunit;

[assembly: System.Runtime.Versioning.SupportedOSPlatform("linux")]

namespace Msisf.Integration.Tests.Run;

/// <summary>What happens when POV-Ray fails: stand-ins for it, written as shell scripts, do what a real one rarely does.</summary>
public sealed class FailingPovRayTests : IDisposable
{
    private const string State =
        "{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_PovRayFails_ShowsItsLastLinesAndLeavesNoFile()
    {
        CommandLineRun run = RunWith("echo 'Parse Error: the moon is made of cheese' >&2; exit 4");

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("exit code 4", run.Error, StringComparison.Ordinal);
        Assert.Contains("made of cheese", run.Error, StringComparison.Ordinal);
        Assert.Matches("\"record\":\"failed\",\"step\":1,.*made of cheese", File.ReadAllLines(_folder["out/msisf-manifest.jsonl"])[^1]);
        AssertHoldsTheManifestOnly();
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_PovRayEndsWellWithoutAnImage_IsAFailure()
    {
        CommandLineRun run = RunWith("exit 0");

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("ended without an image: it printed nothing", run.Error, StringComparison.Ordinal);
        AssertHoldsTheManifestOnly();
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_ImageIsCutOff_IsAFailureAndLeavesNoFile()
    {
        CommandLineRun run = RunWith("printf '\\211PNG\\r\\n\\032\\n' > image.png");

        Assert.NotEqual(0, run.ExitCode);
        Assert.DoesNotContain("bug in msis", run.Error, StringComparison.Ordinal);
        AssertHoldsTheManifestOnly();
    }

    /// <summary>With another version than before all frames would be made again.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_PovRayIsKilledWhenAskedForItsVersion_MakesNothing()
    {
        CommandLineRun run = CommandLineRun.Of(
            ["--fixed-state", State, "--pov-path", StandIn("exit 4", version: "kill -9 $$"), .. RealMoon.Arguments(_folder["out"])]);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("--version: was killed by signal 9", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_PovRayHangs_IsEndedAfterTheTimeout()
    {
        CommandLineRun run = RunWith("sleep 600", "--timeout", "0.5");

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("was ended after 0.5 s", run.Error, StringComparison.Ordinal);
        AssertHoldsTheManifestOnly();
    }

    /// <summary>
    /// Half of the Moon has half a million triangles, so where there are two cores it is drawn in strips; the uppermost fails while the
    /// others work.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_PovRayFailsInAStrip_EndsTheOthersAndIsOneError()
    {
        string marker = _folder["started"];
        string script = $"""
            case "$*" in
                *"+SR1 "*) for i in $(seq 200); do [ -e '{marker}' ] && exit 4; sleep 0.05; done; exit 5 ;;
                *"+SR"*) echo $$ > '{marker}.new'; mv '{marker}.new' '{marker}'; sleep 20; touch '{marker}.end' ;;
                *) exit 4 ;;
            esac
            """;
        CommandLineRun run = CommandLineRun.Of(
        [
            "--state-vectors", "{8.66e6,5e6,0,0,0,100}", "--epoch", "55289", "--time", "55289", "--fov", "22", "--width", "160", "--height",
            "160",
            "--lod-error", "0", "--pov-path", StandIn(script), .. RealMoon.Arguments(_folder["out"]),
        ]);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains(
            "exit code 4",
            Assert.Single(run.Error.Split('\n'), line => line.StartsWith("msis: error:", StringComparison.Ordinal)),
            StringComparison.Ordinal);
        AssertHoldsTheManifestOnly();
        if (Environment.ProcessorCount > 1)
        {
            Assert.False(File.Exists(marker + ".end"), "POV-Ray of another strip was waited for");
            Assert.False(Directory.Exists($"/proc/{File.ReadAllText(marker).Trim()}"), "POV-Ray of another strip still runs");
        }
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_OneFrameOfThreeFails_TheOthersAreComplete()
    {
        // The second camera stands at y = -2000 km; its scene is the one that this stand-in refuses.
        string script = $"grep -q 'location <2000, -2000' scene.pov && exit 9; exec '{TestParts.Program("povray")}' \"$@\"";
        string states = """
            55289 2E6 2E6 0 0 0 3.826834323650898E-1 9.238795325112867E-1
            55289 2E6 -2E6 0 0 0 -3.826834323650898E-1 9.238795325112867E-1
            55289 2E6 2E6 1 0 0 3.826834323650898E-1 9.238795325112867E-1
            """;
        CommandLineRun run = CommandLineRun.Of(
            [
                "--batch-file", "-", "--width", "16", "--height", "16", "--lod", "off", "--pov-path", StandIn(script),
                .. RealMoon.Arguments(_folder["out"]),
            ],
            states);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("step 2 (MoonSurfIllumSim_step_00002)", run.Error, StringComparison.Ordinal);
        Assert.Contains("1 of 3 frames failed: steps 2", run.Error, StringComparison.Ordinal);
        Assert.Equal(
            ["MoonSurfIllumSim_step_00001.png", "MoonSurfIllumSim_step_00003.png"],
            Directory.EnumerateFiles(_folder["out"], "*.png").Select(Path.GetFileName).Order());
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_FailFast_StopsAtTheFirstFailure()
    {
        string states = string.Join(
            '\n', Enumerable.Range(0, 8).Select(step => $"55289 2E6 2E6 {step} 0 0 3.826834323650898E-1 9.238795325112867E-1"));
        CommandLineRun run = CommandLineRun.Of(
            ["--batch-file", "-", "--fail-fast", "--jobs", "1", "--width", "16", "--height", "16", "--pov-path", StandIn("exit 9"),
             .. RealMoon.Arguments(_folder["out"])],
            states);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("Stopped there, as --fail-fast asks", run.Error, StringComparison.Ordinal);
        Assert.InRange(File.ReadAllText(_folder["out/msisf-manifest.jsonl"]).Split("\"record\":\"failed\"").Length - 1, 1, 2);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Run_Cancelled_KillsPovRayAndLeavesNoFile()
    {
        string marker = _folder["started"];
        using CancellationTokenSource stop = new();
        using StringWriter error = new();
        string[] arguments =
        [
            "--fixed-state", State, "--width", "16", "--height", "16",
            "--pov-path", StandIn($"echo $$ > '{marker}.new'; mv '{marker}.new' '{marker}'; sleep 600"),
            .. RealMoon.Arguments(_folder["out"]),
        ];
        ProgramHost host = ConsoleHost.Create(
            TextWriter.Null, error, () => TextReader.Null, TimeProvider.System, Environment.GetEnvironmentVariable);

        Task<int> run = Task.Run(() => Cli.CommandLineProgram.RunAsync(arguments, host, stop.Token));
        await Within.Seconds(120, "the stand-in for POV-Ray", () => File.Exists(marker));
        await stop.CancelAsync();

        Assert.Equal(130, await Within.Seconds(60, "the end of the cancelled run", run));
        int processId = int.Parse(File.ReadAllText(marker), System.Globalization.CultureInfo.InvariantCulture);
        Assert.False(Directory.Exists($"/proc/{processId}"), "POV-Ray still runs");
        AssertHoldsTheManifestOnly();
    }

    private CommandLineRun RunWith(string script, params string[] more) => CommandLineRun.Of(
        ["--fixed-state", State, "--width", "16", "--height", "16", "--pov-path", StandIn(script), .. more, .. RealMoon.Arguments(
            _folder["out"])]);

    private void AssertHoldsTheManifestOnly() => Assert.Equal(
        [".msisf-claims", ".msisf-manifest.lock", "msisf-manifest.jsonl"],
        Directory.EnumerateFileSystemEntries(_folder["out"]).Select(Path.GetFileName).Order(StringComparer.Ordinal));

    private string StandIn(string script, string version = "echo 'POV-Ray 3.7.0.0' && exit")
    {
        string path = _folder["povray-stand-in"];
        File.WriteAllText(path, $"#!/bin/sh\n[ \"$1\" = --version ] && {version}\n{script}\n");
        File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        return path;
    }
}
