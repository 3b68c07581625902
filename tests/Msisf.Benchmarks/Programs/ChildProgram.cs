using System.Diagnostics;
using System.Globalization;

namespace Msisf.Benchmarks.Programs;

/// <summary>Runs a program to its end and watches it.</summary>
internal sealed class ChildProgram
{
    private static readonly TimeSpan OwnInterval = TimeSpan.FromMilliseconds(500);
    private static readonly TimeSpan ChildrenInterval = TimeSpan.FromMilliseconds(50);

    /// <summary>Far above what any run here takes.</summary>
    private static readonly TimeSpan LongestRun = TimeSpan.FromMinutes(30);

    private const int ShownErrorLines = 5;

    private readonly string _file;
    private readonly string _folder;

    /// <summary>Names the program.</summary>
    /// <param name="file">Its file.</param>
    /// <param name="folder">Its working directory.</param>
    public ChildProgram(string file, string folder)
    {
        _file = file;
        _folder = folder;
    }

    /// <summary>This program itself.</summary>
    /// <param name="folder">The working directory.</param>
    public static ChildProgram Self(string folder) =>
        new(Environment.ProcessPath ?? throw new BenchmarkException("the benchmark can't find its own program."), folder);

    /// <summary>Runs it.</summary>
    /// <param name="arguments">Its arguments.</param>
    /// <param name="environment">Variables that it gets beside this process's own.</param>
    /// <param name="watch">Whose memory to look at meanwhile.</param>
    /// <exception cref="BenchmarkException">It can't be started, fails, or hangs; the message has what it said.</exception>
    public ProgramRun Run(
        IReadOnlyList<string> arguments, IReadOnlyDictionary<string, string>? environment = null, MemoryWatch watch = MemoryWatch.None)
    {
        using Process process = new() { StartInfo = StartInfo(arguments, environment) };
        List<(double, string)> output = [];
        List<string> errors = [];
        long start = Stopwatch.GetTimestamp();
        process.OutputDataReceived += (_, line) => Add(output, line.Data, text => (Stopwatch.GetElapsedTime(start).TotalSeconds, text));
        process.ErrorDataReceived += (_, line) => Add(errors, line.Data, text => text);
        try
        {
            process.Start();
        }
        catch (System.ComponentModel.Win32Exception exception)
        {
            throw new BenchmarkException($"{_file}: can't be started: {exception.Message}", exception);
        }

        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        List<MemorySample> memory = [];
        ChildrenMemory children = new(process.Id);
        TimeSpan interval = watch == MemoryWatch.Children ? ChildrenInterval : watch == MemoryWatch.Own ? OwnInterval : LongestRun;
        while (!process.WaitForExit(interval))
        {
            double elapsed = Stopwatch.GetElapsedTime(start).TotalSeconds;
            if (elapsed > LongestRun.TotalSeconds)
            {
                process.Kill(entireProcessTree: true);
                throw new BenchmarkException($"{_file} {string.Join(' ', arguments)}: did not end within {LongestRun}");
            }

            if (watch == MemoryWatch.Children)
            {
                children.Look();
            }
            else if (watch == MemoryWatch.Own && MemorySample.Of(process, elapsed) is MemorySample sample)
            {
                memory.Add(sample);
            }
        }

        process.WaitForExitAsync().Wait(LongestRun); // for the end of both pipes, too
        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        return process.ExitCode == 0
            ? new ProgramRun(seconds, output, errors, memory, children.PeakBytes)
            : throw new BenchmarkException(string.Create(
                CultureInfo.InvariantCulture,
                $"{_file} {string.Join(' ', arguments)}: exit code {process.ExitCode}: "
                    + $"{string.Join(" / ", errors.TakeLast(ShownErrorLines))}"));
    }

    private static void Add<T>(List<T> list, string? line, Func<string, T> item)
    {
        if (line is not null)
        {
            list.Add(item(line));
        }
    }

    private ProcessStartInfo StartInfo(IReadOnlyList<string> arguments, IReadOnlyDictionary<string, string>? environment)
    {
        ProcessStartInfo info = new(_file, arguments)
        {
            WorkingDirectory = _folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        foreach ((string name, string value) in environment ?? new Dictionary<string, string>())
        {
            info.Environment[name] = value;
        }

        return info;
    }
}
