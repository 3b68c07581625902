using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Run;

/// <summary>The real model, with one pattern repository for all tests of this project, so that patterns are made once.</summary>
internal static class RealMoon
{
    private static readonly Lazy<TemporaryFolder> Shared = new(() =>
    {
        TemporaryFolder folder = new();
        AppDomain.CurrentDomain.ProcessExit += (_, _) => folder.Dispose();
        return folder;
    });

    /// <summary>The repository of patterns.</summary>
    public static string Repository => Shared.Value["patterns"];

    /// <summary>The arguments that every run of these tests has: the real model, this repository, an output folder.</summary>
    /// <param name="output">Folder of the outputs.</param>
    public static string[] Arguments(string output) =>
        ["--ldem", TestParts.Ldem4Label!, "--pattern-repos", Repository, "--output-dir", output, "--ephemeris", "builtin", "--batch"];
}
