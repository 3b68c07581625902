using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Run;

/// <summary>A folder for outputs, and one pattern repository for all tests of a class, so that patterns are made once.</summary>
public sealed class RenderFixture : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    /// <summary>The repository of patterns.</summary>
    public string Repository => _folder["patterns"];

    /// <summary>The arguments that every run of these tests has: the real model, this repository, an output folder.</summary>
    /// <param name="output">Folder of the outputs.</param>
    public string[] Common(string output) =>
        ["--ldem", TestParts.Ldem4Label!, "--pattern-repos", Repository, "--output-dir", output, "--ephemeris", "builtin", "--batch"];

    public void Dispose() => _folder.Dispose();
}
