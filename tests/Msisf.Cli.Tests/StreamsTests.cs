using Msisf.App.Host;
using Msisf.Cli.Output;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Standard input, output and error that do not do what a program hopes for, and files of arguments.</summary>
public sealed class StreamsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_StandardOutputIsFull_SaysSoWithoutAStack()
    {
        using StringWriter error = new();

        int exitCode = Run(["--help"], new FullWriter(), error);

        Assert.Equal(3, exitCode);
        Assert.Equal("msis: error: standard output can't be written: No space left on device", error.ToString().Trim());
    }

    [Fact]
    public void Run_StandardErrorIsFull_StillEndsWithTheExitCode() =>
        Assert.Equal(1, Run(["--widht", "5"], TextWriter.Null, new FullWriter()));

    [Fact]
    public async Task Run_CancelledWhileStandardInputIsSilent_EndsAtOnce()
    {
        using CancellationTokenSource stop = new();
        using SilentReader input = new(stop);
        using StringWriter error = new();
        string[] arguments = ["--batch-file", "-"];
        ProgramHost host = ConsoleHost.Create(TextWriter.Null, error, () => input, TimeProvider.System, _ => null);

        Task<int> run = Task.Run(() => CommandLineProgram.RunAsync(arguments, host, stop.Token));

        Assert.Equal(130, await Within.Seconds(60, "the end of the cancelled run", run));
    }

    [Fact]
    public void Run_FileOfArguments_HasCommentsAndQuotedBlanks()
    {
        File.WriteAllText(_folder["a.rsp"], "--fixed-state {55289,2E6,2E6,0,0,0,0,1}\r\n  # comment\r\n--output-name \"a b/c\"\r\n");
        using StringWriter error = new();

        int exitCode = Run([$"@{_folder["a.rsp"]}"], TextWriter.Null, error);

        Assert.Equal(1, exitCode);
        Assert.Contains("--output-name 'a b/c': a file name is needed", error.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_FileOfArgumentsNamesItself_IsRefused()
    {
        File.WriteAllText(_folder["a.rsp"], $"@{_folder["a.rsp"]}\n");
        using StringWriter error = new();

        int exitCode = Run([$"@{_folder["a.rsp"]}"], TextWriter.Null, error);

        Assert.Equal(1, exitCode);
        Assert.Contains("a file of arguments can't name another one", error.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_NulInResponseFile_IsRefused()
    {
        File.WriteAllText(_folder["a.rsp"], "--fixed-state {55289,2E6,2E6,0,0,0,0,1}\n--kernels a\0b\n");
        using StringWriter error = new();
        int exitCode = Run([$"@{_folder["a.rsp"]}"], TextWriter.Null, error);

        Assert.Equal(1, exitCode);
        Assert.Contains("holds a NUL character: it is not a text file", error.ToString(), StringComparison.Ordinal);
    }

    private static int Run(string[] arguments, TextWriter output, TextWriter error) => CommandLineProgram
        .RunAsync(arguments, ConsoleHost.Create(output, error, () => TextReader.Null, TimeProvider.System, _ => null))
        .GetAwaiter()
        .GetResult();

    /// <summary>/dev/full.</summary>
    private sealed class FullWriter : StringWriter
    {
        public override void Write(char value) => throw new IOException("No space left on device");

        public override void Write(string? value) => throw new IOException("No space left on device");

        public override void WriteLine(string? value) => throw new IOException("No space left on device");
    }

    /// <summary>A terminal at which nobody types; that it is read cancels the run.</summary>
    private sealed class SilentReader(CancellationTokenSource stop) : TextReader
    {
        private readonly ManualResetEventSlim _closed = new();

        public override int Read(char[] buffer, int index, int count)
        {
            stop.Cancel();
            _closed.Wait(TimeSpan.FromMinutes(2)); // longer than the test waits
            return 0;
        }

        protected override void Dispose(bool disposing)
        {
            _closed.Set();
            base.Dispose(disposing);
        }
    }
}
