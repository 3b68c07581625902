using System.Runtime.Versioning;
using System.Text;
using Msisf.Adapters.Input;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Output;
using Msisf.Core.Scene;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary>What <c>msis batchconvert</c> writes, and what it refuses.</summary>
[SupportedOSPlatform("linux")]
public sealed class BatchConvertTests : IDisposable
{
    private const string Fixed = "--fixed-state {55289,2E6,2E6,0,0,0,0,1} --renderer native";
    private const string Orbit = "--kepler-set {2.5E6,0.1,0.3,0.2,1.2,0.5} --epoch 55289 --time-interval [55289:0.0001:55289.2]";

    private readonly ConvertedScript _converted = new();
    private readonly TemporaryFolder _folder;

    public BatchConvertTests() => _folder = _converted.Folder;

    public void Dispose() => _converted.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Convert_BatchFile_NamesThatFileAndCopiesNothing()
    {
        string batch = _folder.Write("my run.tab", "55289 2E6 2E6 0 0 0 0 1\n55290 2E6 2E6 0 0 0 0 1\n");

        CommandLineRun run = CommandLineRun.Of(
            ["batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "2", "--batch-file", batch,
             .. ConvertedScript.Common]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(_folder["b.sh"], run.Output.TrimEnd());
        Assert.Equal([_folder["b.sh"], batch], Directory.EnumerateFileSystemEntries(_folder.Path).Order(StringComparer.Ordinal));
        Assert.Contains($"'--batch-file={batch}'", File.ReadAllText(_folder["b.sh"]), StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("--kepler-set {2.5E6,0.1,0.3,0.2,1.2,0.5} --epoch 55289 --time-interval [55289:0.00123:55289.9]")]
    [InlineData(
        "--kepler-set {2.5E6,0.1,0.3,0.2,1.2,0.5} --epoch 55289 --time-interval [55289:0.00123:55289.9] --attitude "
            + "{0.1,0.2,0.3,0.9273618495495703} --attitude-transition {1E-3,2E-3,3E-4}")]
    [InlineData("--state-vectors {2E6,3E5,1E5,10,1500,300} --epoch 55289.1 --times {55289.2,55289.30000001,55290}")]
    [InlineData("--fixed-state {55289.123456789,2E6,2E6,0,0.1,0.2,0.3,0.9273618495495703}")]
    public void Convert_Orbit_WritesStatesThatReadBackBitForBit(string mode)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["batchconvert", "--format", "sh", "--script", _folder["o.sh"], "--pieces", "2", .. mode.Split(' '), "--renderer",
             "native", .. ConvertedScript.Common]);

        Assert.True(run.ExitCode == 0, run.Error);
        using StreamReader reader = new(_folder["o.sh.states.tab"]);
        Assert.Equal(StatesOf(mode.Split(' ')), BatchFileReader.Read(reader, "states", new SphereScene()));
    }

    /// <summary>The pieces scan along the same motion, and shake the camera themselves.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(",vx,vy,vz,wx,wy,wz", ",1,1500.5,-3,0.01,0.02,0.03", "")]
    [InlineData("", "", "--motion {1,1500.5,-3,0.01,0.02,0.03}")]
    public void Convert_ScanThatOptionsExplain_WritesItsMotionWithoutJitter(string columns, string numbers, string option)
    {
        string batch = _folder.Write("b.csv", $"seconds,x,y,z,qw,qx,qy,qz{columns}\n0,1900000,0,0,1,0,0,0{numbers}\n");
        string camera = _folder.Write(
            "line.yaml", "focal-length-px: 90\nwidth: 40\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.1\n");

        CommandLineRun run = CommandLineRun.Of(
            [
                "batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "1", "--renderer", "native",
                "--batch-file", batch, "--epoch", "55289", "--camera", camera, "--lines", "9", "--jitter",
                _folder.Write("jitter.txt", "pitch 0.4 9000 1\n"), .. option.Split(' ', StringSplitOptions.RemoveEmptyEntries),
                .. ConvertedScript.Common,
            ]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(
            ["55289 1900000 0 0 0 0 0 1 1 1500.5 -3 0.01 0.02 0.03"],
            File.ReadLines(_folder["b.sh.states.tab"]).Where(line => line[0] != '#'));
    }

    /// <summary>The pieces do not get the options that say how its numbers are meant.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Convert_BatchFileThatOptionsExplain_WritesItsStates()
    {
        string batch = _folder.Write(
            "b.csv", "seconds,x_km,y_km,z_km,qw,qx,qy,qz,fuel\n0,2000,0,0,0.99999,0,0,0,7\n43200,0,2000,0,1,0,0,0,6\n");

        CommandLineRun run = CommandLineRun.Of(
            [
                "batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "1", "--renderer", "native",
                "--batch-file", batch, "--epoch", "55289", "--ignore-columns", "--normalize", .. ConvertedScript.Common,
            ]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains($"'--batch-file={_folder["b.sh.states.tab"]}'", File.ReadAllText(_folder["b.sh"]), StringComparison.Ordinal);
        Assert.Equal(
            ["55289 2000000 0 0 0 0 0 1", "55289.5 0 2000000 0 0 0 0 1"],
            File.ReadLines(_folder["b.sh.states.tab"]).Where(line => line[0] != '#'));
    }

    [RequiresFact(Part.Ldem4)]
    public void Convert_Orbit_SaysInBothFilesWhichCallMadeThem()
    {
        string script = _converted.Convert("sh", "run.sh", "--pieces", "1");

        string head = File.ReadLines(script).ElementAt(1);
        Assert.StartsWith("# Made by msis ", head, StringComparison.Ordinal);
        Assert.Contains(": msis batchconvert --format sh ", head, StringComparison.Ordinal);
        Assert.Equal(head, File.ReadLines(script + ".states.tab").First());
    }

    [RequiresFact(Part.Ldem4)]
    public void Convert_ToBat_IsForWindows()
    {
        string script = _converted.Convert("bat", "100% M\u00f6nd/run.bat", "--pieces", "2", "--output-name", "50% {step}");

        byte[] bytes = File.ReadAllBytes(script);
        string text = Encoding.UTF8.GetString(bytes);
        Assert.NotEqual(0xEF, bytes[0]);
        Assert.Equal(text.Count(character => character == '\n'), text.Split("\r\n").Length - 1);
        Assert.Contains("\r\ncall :piece \"1:5\"\r\ncall :piece \"6:10\"\r\n", text, StringComparison.Ordinal);
        Assert.Contains("\"--output-name=50%% {step}\"", text, StringComparison.Ordinal);
        Assert.Contains("100%% M\u00f6nd/run.bat.states.tab\"", text, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4, Part.Shellcheck)]
    [InlineData("sh")]
    [InlineData("parallel")]
    [InlineData("slurm")]
    public void Convert_ForAShell_IsCleanByShellcheck(string format)
    {
        string script = _converted.Convert(format, "run.sh", "--pieces", "3", "--output-dir", "it's; here");

        ChildRun run = ChildRun.Of("shellcheck", ["--shell=sh", script], _folder.Path);

        Assert.True(run.ExitCode == 0, run.Output);
    }

    [Theory]
    [InlineData("", 1, "--format")]
    [InlineData($"--format sh {Fixed}", 1, "nothing says how the run is cut")]
    [InlineData($"--format sh --pieces 2 --frames-per-piece 3 {Fixed}", 1, "--pieces and --frames-per-piece exclude each other")]
    [InlineData($"--format sh --pieces 0 {Fixed}", 1, "--pieces is '0'")]
    [InlineData($"--format sh --frames-per-piece x {Fixed}", 1, "--frames-per-piece is 'x'")]
    [InlineData($"--format pbs --pieces 2 {Fixed}", 1, "--format is 'pbs'; one of sh, bat, parallel, slurm is needed")]
    [InlineData("--format sh --pieces 2", 1, "nothing says where the camera is")]
    [InlineData("--format sh --pieces 2 --batch-file -", 1, "standard input can't be read again by each piece")]
    [InlineData("--format sh --pieces 2 --batch-file missing.tab", 2, "missing.tab: there is no such file")]
    [InlineData($"--format sh --pieces 2 {Fixed} --overwrite", 1, "--overwrite would make all frames again")]
    [InlineData($"--format sh --pieces 2 {Fixed} --frame-times t.tsv", 1, "--frame-times names one file")]
    [InlineData(
        "--format sh --pieces 2 --fixed-state {55289,2E6,2E6,0,0,0,0,1} --list-patterns", 1, "--list-patterns prints and makes no frame")]
    [InlineData($"--format sh --pieces 2 {Fixed} --frames 1:2", 1, "--frames 1:2: step 2 is wanted, but the run has 1 only")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --frames 1", 1, "--frames makes a part of the run, and this script looks at all of it")]
    [InlineData($"--format sh --pieces 2 {Fixed} --width 0", 1, "--width is '0'")]
    [InlineData($"--format sh --pieces 2 {Orbit} --output-name same", 1, "would both be written to same")]
    [InlineData($"--format sh --pieces 2 {Fixed} --partition long", 1, "--partition is for --format slurm only")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --memory much", 1, "--memory is 'much'; a size is needed")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --time-limit long", 1, "--time-limit is 'long'; a time is needed")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --concurrency 0", 1, "--concurrency is '0'")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --retries -1", 1, "--retries is '-1'")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --video 0", 1, "--video is 0")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --sbatch-options array=1-5", 1, "--sbatch-options: array is set by msis itself")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --sbatch-options QOS=1", 1, "--sbatch-options: 'QOS=1' is none")]
    [InlineData($"--format slurm --pieces 2 {Fixed} --partition a;b", 1, "--partition is 'a;b'; a name without blanks is needed")]
    public void Convert_WrongInput_EndsWithCodeAndOneLine(string words, int exitCode, string message) => Refused(words, exitCode, message);

    [RequiresTheory(Part.Ldem4)]
    [InlineData($"--format slurm --frames-per-piece 1 {Orbit} --renderer native", 1, "2001 pieces; a Slurm array has 1000 at most")]
    [InlineData($"--format slurm --pieces 1 --memory 1M {Fixed}", 2, "of memory, 1 MiB are there")]
    [InlineData(
        $"--format sh --pieces 1 {Orbit} --renderer native --width 2048 --height 2048 --surface terrain --grid 1",
        2,
        "2001 frames will take about")]
    [InlineData("--format sh --pieces 2 --fixed-state {55289,1.7E6,0,0,0,0,0,1}", 2, "the camera is inside the Moon")]
    [InlineData($"--format bat --pieces 1 {Fixed} --output-name a\"b", 1, "has a quotation mark")]
    public void Convert_WrongInputThatTheModelShows_EndsWithCodeAndOneLine(string words, int exitCode, string message) =>
        Refused(words, exitCode, message);

    private void Refused(string words, int exitCode, string message)
    {
        string[] ldem = TestParts.Ldem4Label is string label ? ["--ldem", label] : [];
        CommandLineRun run = CommandLineRun.Of(
            ["batchconvert", .. words.Split(
                ' ', StringSplitOptions.RemoveEmptyEntries), "--script", _folder["s"], "--ephemeris", "builtin", .. ldem]);

        Assert.True(exitCode == run.ExitCode, $"exit code {run.ExitCode}, expected {exitCode}: {run.Error}");
        string error = Assert.Single(run.Error.Split('\n'), line => line.StartsWith("msis: error: ", StringComparison.Ordinal));
        Assert.Contains(message, error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    /// <summary>The states that the render command takes images of.</summary>
    private static IReadOnlyList<SpacecraftState> StatesOf(string[] mode)
    {
        OptionValues values = new(mode.Chunk(2).Select(pair => KeyValuePair.Create(pair[0], new OptionValue([pair[1]]))));
        ProgramHost host = ConsoleHost.Create(TextWriter.Null, TextWriter.Null, () => TextReader.Null, TimeProvider.System, _ => null);
        return new StateReader(
            () => throw new InvalidOperationException("no ephemeris is needed"),
            new SphereScene(),
            host).Read(TrajectorySettingsReader.Read(values), CancellationToken.None);
    }
}
