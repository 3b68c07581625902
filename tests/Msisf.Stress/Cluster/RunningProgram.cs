using System.Diagnostics;
using System.Text;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>A program that runs beside the test, which may kill it. It does not outlive this object.</summary>
internal sealed class RunningProgram : IDisposable
{
    private readonly Process _process;
    private readonly StringBuilder _output = new();
    private readonly StringBuilder _error = new();

    private RunningProgram(ProcessStartInfo start, Action<string>? onLine)
    {
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, line) => Append(_output, line.Data, onLine);
        _process.ErrorDataReceived += (_, line) => Append(_error, line.Data, null);
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
        _process.StandardInput.Close();
    }

    /// <summary>Of the process.</summary>
    public int Id => _process.Id;

    /// <summary>Whether it has ended by itself or was killed.</summary>
    public bool HasEnded => _process.HasExited;

    /// <summary>Starts a program.</summary>
    /// <param name="program">Its file.</param>
    /// <param name="arguments">As its <c>main</c> gets them.</param>
    /// <param name="folder">Its working directory.</param>
    /// <param name="environment">Variables that it gets beside this process's own.</param>
    /// <param name="onLine">Gets each line of standard output as it comes, on another thread.</param>
    public static RunningProgram Start(
        string program,
        IReadOnlyList<string> arguments,
        string folder,
        IReadOnlyDictionary<string, string>? environment = null,
        Action<string>? onLine = null)
    {
        ProcessStartInfo start = new(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = folder,
        };
        foreach ((string name, string value) in environment ?? new Dictionary<string, string>())
        {
            start.Environment[name] = value;
        }

        return new RunningProgram(start, onLine);
    }

    /// <summary>Waits for its end.</summary>
    /// <param name="limit">It is killed, and this fails, if it takes longer.</param>
    /// <exception cref="TimeoutException">It did; the message has what it said.</exception>
    public ChildRun End(TimeSpan limit)
    {
        if (!_process.WaitForExit(limit))
        {
            _process.Kill(entireProcessTree: true);
            throw new TimeoutException($"{Call} did not end within {limit}: {Text(_error)}{Text(_output)}");
        }

        _process.WaitForExit(); // and for the end of both pipes
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

    private static void Append(StringBuilder text, string? line, Action<string>? onLine)
    {
        if (line is null)
        {
            return;
        }

        lock (text)
        {
            text.Append(line).Append('\n');
        }

        onLine?.Invoke(line);
    }

    private static string Text(StringBuilder text)
    {
        lock (text)
        {
            return text.ToString();
        }
    }
}
