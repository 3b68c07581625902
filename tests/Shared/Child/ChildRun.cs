using System.Diagnostics;
using System.Text;

namespace Msisf.TestSupport;

/// <summary>One run of another program, and what came of it.</summary>
internal sealed record ChildRun(int ExitCode, string Output, string Error)
{
    /// <summary>Runs a program to its end.</summary>
    /// <param name="program">Its file.</param>
    /// <param name="arguments">As its <c>main</c> gets them.</param>
    /// <param name="folder">Its working directory.</param>
    /// <param name="standardInput">What stands on its standard input.</param>
    public static ChildRun Of(string program, IReadOnlyList<string> arguments, string folder, string standardInput = "")
    {
        ProcessStartInfo start = new(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = folder,
        };
        start.Environment["XDG_CONFIG_HOME"] = "/no-settings"; // those of whoever runs the tests play no part
        StringBuilder error = new();
        using Process process = new() { StartInfo = start };
        process.ErrorDataReceived += (_, line) => error.Append(line.Data is null ? string.Empty : line.Data + "\n");
        process.Start();
        process.BeginErrorReadLine();
        process.StandardInput.Write(standardInput);
        process.StandardInput.Close();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return new ChildRun(process.ExitCode, output, error.ToString());
    }

    /// <summary>This run, if it went well.</summary>
    /// <exception cref="InvalidOperationException">It did not; the message has what the program said.</exception>
    public ChildRun Succeeded() =>
        ExitCode == 0 ? this : throw new InvalidOperationException($"exit code {ExitCode}: {Error}{Output}");
}
