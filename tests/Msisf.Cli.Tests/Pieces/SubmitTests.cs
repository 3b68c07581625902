using System.Runtime.Versioning;
using Msisf.Adapters.Cluster;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.Cli.Output;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary><c>msis submit</c> and what follows the jobs, with commands of Slurm that only answer.</summary>
[SupportedOSPlatform("linux")]
public sealed class SubmitTests : IDisposable
{
    private static readonly string[] Run =
        ["submit", "--pieces", "2", "--fixed-state", "{55289,2E6,2E6,0,0,0,0,1}", "--renderer", "native", "--ephemeris", "builtin"];

    private readonly ConvertedScript _converted = new();
    private readonly TemporaryFolder _folder;

    public SubmitTests() => _folder = _converted.Folder;

    private string Output => _folder["out"];

    private ConvertedRun Submitted => new(_folder["run.sh"], null, Output, 10, 2);

    public void Dispose() => _converted.Dispose();

    [Fact]
    public void Submit_NoSlurm_NamesTheAlternatives()
    {
        (int code, _, string error) = Call([.. Run, "--output-dir", Output], path: "/nowhere");

        Assert.Equal(3, code);
        Assert.Contains("no sbatch on the PATH", error, StringComparison.Ordinal);
        Assert.Contains("--format parallel", error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Output));
    }

    [RequiresFact(Part.Ldem4)]
    public void Submit_WithoutWait_PrintsTheJobs()
    {
        string bin = WriteCommand("sbatch", "echo 7");

        (int code, string output, string error) = Call(
            [.. Run, "--ldem", TestParts.Ldem4Label!, "--output-dir", Output], $"{bin}:/usr/bin:/bin");

        Assert.True(code == 0, error);
        Assert.Equal("round 0: 1 pieces, job 7\nround 0: check, job 7\n", output);
        Assert.True(File.Exists(Path.Combine(Output, "msis-pieces.slurm.sh")));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(0, "1 frames are there and complete")]
    [InlineData(5, "frames are missing after all retries")]
    [InlineData(3, "the last job ended with exit code 3")]
    public void Submit_Wait_EndsWithTheCodeOfTheWhole(int result, string message)
    {
        string bin = WriteCommand("sbatch", $"echo 7\necho {result} >'{Output}/msis-pieces.slurm.sh.result'");

        (int code, _, string error) = Call(
            [.. Run, "--wait", "--ldem", TestParts.Ldem4Label!, "--output-dir", Output], $"{bin}:/usr/bin:/bin");

        Assert.Equal(result, code);
        Assert.Contains(message, error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Submit_SbatchFails_SaysWhatItSaid()
    {
        string bin = WriteCommand("sbatch", "echo 'sbatch: error: invalid partition' >&2; exit 1");

        (int code, _, string error) = Call([.. Run, "--ldem", TestParts.Ldem4Label!, "--output-dir", Output], $"{bin}:/usr/bin:/bin");

        Assert.Equal(3, code);
        Assert.Contains("Slurm takes no job: sbatch: error: invalid partition", error, StringComparison.Ordinal);
    }

    /// <summary>The third question is answered with the end of the jobs.</summary>
    [Fact]
    public async Task Follow_ControllerAway_GoesOnUntilTheResult()
    {
        Directory.CreateDirectory(Output);
        string bin = WriteCommand(
            "squeue",
            $"echo x >>'{_folder["asked"]}'\n[ \"$(wc -l <'{_folder["asked"]}')\" -lt 3 ] || echo 5 >'{_folder["run.sh.result"]}'\necho "
                + $"'Unable to contact slurm controller' >&2; exit 1");

        Assert.Equal(5, await Follow(bin, TextWriter.Null, CancellationToken.None));

        Assert.Equal(3, File.ReadLines(_folder["asked"]).Count());
    }

    [Fact]
    public async Task Follow_NoJobsAndNoResult_IsAnError()
    {
        Directory.CreateDirectory(Output);

        ExternalPartException error = await Assert.ThrowsAsync<ExternalPartException>(
            () => Follow(WriteCommand("squeue", "exit 0"), TextWriter.Null, CancellationToken.None));

        Assert.Contains("all jobs are gone", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Follow_EndedByTheUser_SaysHowToGoOn()
    {
        Directory.CreateDirectory(Output);
        using CancellationTokenSource user = new();
        using StringWriter log = new();
        Task<int> following = Follow(WriteCommand("squeue", "echo 7"), log, user.Token);

        await user.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => following);
        Assert.Contains($"msis status '{Output}'", log.ToString(), StringComparison.Ordinal);
    }

    private Task<int> Follow(string bin, TextWriter log, CancellationToken cancellation)
    {
        ProgramHost host = ConsoleHost.Create(TextWriter.Null, log, () => TextReader.Null, TimeProvider.System, _ => null);
        SlurmWatch watch = new(
            Submitted, new SlurmProgram($"{bin}:/usr/bin:/bin"), host, TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(100));
        return watch.FollowAsync(cancellation);
    }

    private string WriteCommand(string name, string text) => Path.GetDirectoryName(_converted.WriteProgram($"bin/{name}", text))!;

    private static (int Code, string Output, string Error) Call(string[] arguments, string path)
    {
        using StringWriter output = new();
        using StringWriter error = new();
        ProgramHost host = ConsoleHost.Create(
            output, error, () => TextReader.Null, TimeProvider.System, name => name == "PATH" ? path : null);
        int code = CommandLineProgram.RunAsync(arguments, host).GetAwaiter().GetResult();
        return (code, output.ToString(), error.ToString());
    }
}
