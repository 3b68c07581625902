using System.Diagnostics;
using System.Text;

namespace Msisf.TestSupport;

/// <summary>A program that runs beside the test, which may kill it. It does not outlive this object.</summary>
internal sealed class RunningProgram : IDisposable
{
    private readonly Process _process;
    private readonly StringBuilder _output = new();
    private readonly StringBuilder _error = new();
    private readonly Task _readers;

    private RunningProgram(ProcessStartInfo start, string standardInput, Action<string>? onOutput)
    {
        _process = Process.Start(start)!;
        _readers = Task.WhenAll(ReadAsync(_process.StandardOutput, _output, onOutput), ReadAsync(_process.StandardError, _error, null));
        _process.StandardInput.Write(standardInput);
        _process.StandardInput.Close();
    }

    /// <summary>Of the process.</summary>
    public int Id => _process.Id;

    /// <summary>Starts a program. The settings of whoever runs the tests play no part.</summary>
    /// <param name="program">Its file.</param>
    /// <param name="arguments">As its <c>main</c> gets them.</param>
    /// <param name="folder">Its working directory.</param>
    /// <param name="standardInput">What stands on its standard input.</param>
    /// <param name="environment">Variables that it gets beside this process's own.</param>
    /// <param name="onOutput">Gets what it writes to standard output as it comes, in pieces of any length, on another thread.</param>
    public static RunningProgram Start(
        string program,
        IReadOnlyList<string> arguments,
        string folder,
        string standardInput = "",
        IReadOnlyDictionary<string, string>? environment = null,
        Action<string>? onOutput = null)
    {
        ProcessStartInfo start = new(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = folder,
        };
        start.Environment["XDG_CONFIG_HOME"] = "/no-settings";
        foreach ((string name, string value) in environment ?? new Dictionary<string, string>())
        {
            start.Environment[name] = value;
        }

        return new RunningProgram(start, standardInput, onOutput);
    }

    /// <summary>Waits for its end.</summary>
    /// <param name="limit">It is killed, and this fails, if it takes longer.</param>
    /// <exception cref="TimeoutException">It did; the message has what it said.</exception>
    public ChildRun End(TimeSpan limit)
    {
        if (!_process.WaitForExit(limit) || !_readers.Wait(limit)) // what it started may keep its pipes open
        {
            _process.Kill(entireProcessTree: true);
            throw new TimeoutException($"{Call} did not end within {limit}: {Text(_error)}{Text(_output)}");
        }

        return new ChildRun(_process.ExitCode, Text(_output), Text(_error));
    }

    /// <summary>Lets it run for a while.</summary>
    /// <returns>Whether it has ended meanwhile.</returns>
    public bool EndsWithin(TimeSpan time) => _process.WaitForExit(time);

    /// <summary>Ends it, but not what it has started, by SIGKILL.</summary>
    public void Kill() => _process.Kill();

    public void Dispose()
    {
        if (!_process.HasExited)
        {
            _process.Kill(entireProcessTree: true);
        }

        _process.Dispose();
    }

    private string Call => $"{_process.StartInfo.FileName} {string.Join(' ', _process.StartInfo.ArgumentList)}";

    private static async Task ReadAsync(StreamReader pipe, StringBuilder text, Action<string>? onText)
    {
        char[] buffer = new char[4096];
        for (int count; (count = await pipe.ReadAsync(buffer).ConfigureAwait(false)) > 0;)
        {
            lock (text)
            {
                text.Append(buffer, 0, count);
            }

            onText?.Invoke(new string(buffer, 0, count));
        }
    }

    private static string Text(StringBuilder text)
    {
        lock (text)
        {
            return text.ToString();
        }
    }
}
