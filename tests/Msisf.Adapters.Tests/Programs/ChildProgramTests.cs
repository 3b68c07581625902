using Msisf.Adapters.Programs;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Programs;

public sealed class ChildProgramTests
{
    /// <summary>More than a pipe holds: a program whose pipe nobody drains stops there.</summary>
    private const int ManyBytes = 1_000_000;

    [Fact]
    public async Task Run_MuchOutputOnBothPipes_GivesAllOfItAndTheExitCode()
    {
        ProcessResult result = await Shell($"head -c {ManyBytes} /dev/zero; head -c {ManyBytes} /dev/zero >&2; exit 7")
            .RunAsync(CancellationToken.None);

        Assert.Equal((7, ManyBytes, ManyBytes), (result.ExitCode, result.Output.Length, result.Error.Length));
    }

    [Fact]
    public async Task Run_ReadsStandardInput_FindsItEmpty() =>
        Assert.Equal("end", (await Shell("cat; printf end").RunAsync(CancellationToken.None)).Output);

    /// <summary>The program reads its input to the end and ends by itself.</summary>
    [Fact]
    public async Task RunUntilInputEnds_Cancelled_LetsTheProgramEnd()
    {
        using CancellationTokenSource end = new();
        Task<int> running = Shell("cat; exit 7").RunUntilInputEndsAsync(end.Token);
        Assert.False(running.IsCompleted);

        await end.CancelAsync();

        Assert.Equal(7, await Within.Seconds(60.0, "the end of the program", running));
    }

    [Fact]
    public async Task Run_FolderAndVariableGiven_ProgramHasThem()
    {
        ChildProgram program = Shell("pwd; printf %s \"$COLOUR\"") with
        {
            WorkingFolder = "/",
            Environment = new Dictionary<string, string> { ["COLOUR"] = "grey" },
        };

        Assert.Equal("/\ngrey", (await program.RunAsync(CancellationToken.None)).Output);
    }

    [Fact]
    public async Task Run_LongerThanTheLimit_IsEndedWithItsChildren()
    {
        ChildProgram program = Shell("sleep 1000 & wait") with { TimeLimit = TimeSpan.FromMilliseconds(200) };

        TimeoutException exception = await Assert.ThrowsAsync<TimeoutException>(() => program.RunAsync(CancellationToken.None));

        Assert.Equal("/bin/sh was ended after 0.2 s", exception.Message);
    }

    [Fact]
    public async Task Run_Cancelled_Throws()
    {
        using CancellationTokenSource cancellation = new(TimeSpan.FromMilliseconds(200));

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => Shell("sleep 1000 & wait").RunAsync(cancellation.Token));
    }

    [Fact]
    public async Task Run_MissingProgram_IsNamed()
    {
        ExternalPartException exception = await Assert.ThrowsAsync<ExternalPartException>(
            () => new ChildProgram("/no/such/program", []).RunAsync(CancellationToken.None));

        Assert.StartsWith("/no/such/program: can't be started: ", exception.Message, StringComparison.Ordinal);
    }

    private static ChildProgram Shell(string script) => new("/bin/sh", ["-c", script]);
}
