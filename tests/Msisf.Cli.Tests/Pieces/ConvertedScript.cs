using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary>A run of ten frames as a script, and a program for it that only notes how it was called.</summary>
[SupportedOSPlatform("linux")]
internal sealed class ConvertedScript : IDisposable
{
    private static readonly string[] Orbit =
        ["--kepler-set", "{2.5E6,0.1,0.3,0.2,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.01:55289.095]"];

    /// <summary>What each conversion here needs.</summary>
    public static string[] Common => ["--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin"];

    public TemporaryFolder Folder { get; } = new();

    /// <summary>A line for each call of the program: its arguments, a bar behind each.</summary>
    public string Calls => Folder["calls"];

    public void Dispose() => Folder.Dispose();

    /// <summary>Makes a script.</summary>
    /// <param name="format">For whom.</param>
    /// <param name="name">Its name in the folder.</param>
    /// <param name="options">How it is cut, and what differs from the native renderer's defaults.</param>
    /// <returns>Its path.</returns>
    public string Convert(string format, string name, params string[] options)
    {
        string script = Folder[name];
        string[] renderer = options.Contains("--renderer") ? [] : ["--renderer", "native"];
        CommandLineRun made = CommandLineRun.Of(
            ["batchconvert", "--format", format, "--script", script, .. Orbit, .. renderer, .. options, .. Common]);
        Assert.True(made.ExitCode == 0, made.Error);
        Assert.Equal($"{script}\n{script}.states.tab", made.Output.ReplaceLineEndings("\n").TrimEnd());
        return script;
    }

    /// <summary>Writes a program.</summary>
    /// <param name="name">Its name in the folder.</param>
    /// <param name="text">For sh.</param>
    /// <returns>Its path.</returns>
    public string WriteProgram(string name, string text)
    {
        string path = Folder.Write(name, $"#!/bin/sh\n{text}\n");
        File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        return path;
    }

    /// <summary>Writes the program that notes its arguments.</summary>
    /// <param name="body">What else it does.</param>
    /// <returns>Its path.</returns>
    public string FakeMsis(string body = "") =>
        WriteProgram("fake msis", $"line=$(printf '%s|' \"$@\")\nprintf '%s\\n' \"$line\" >>'{Calls}'\n{body}");

    /// <summary>Runs a script from a folder that has nothing to do with it.</summary>
    public static ChildRun Run(string script, string msis, params string[] arguments) =>
        ChildRun.Of("env", [$"MSIS={msis}", "sh", script, .. arguments], "/");

    /// <summary>The frames of each call that made some.</summary>
    public string[] PieceCalls() =>
        [.. File.ReadAllLines(Calls).Where(
            line => line.Contains("|--frames|", StringComparison.Ordinal)).Select(line => line.Split('|')[^2])];
}
