using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>A coarse invented Moon for the tests of a class, and runs over it.</summary>
public sealed class SmallMoon : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly Lazy<string> _model;

    public SmallMoon() => _model = new Lazy<string>(() =>
    {
        CommandLineRun run = CommandLineRun.Of(["ldem", "synthesize", "--res", "2", "--seed", "1", "--output-dir", _folder["moon"]]);
        Assert.True(run.ExitCode == 0, run.Error);
        return _folder["moon"];
    });

    /// <summary>The options that name it.</summary>
    public string[] Options => ["--ldem", _model.Value, "--res", "2"];

    public void Dispose() => _folder.Dispose();

    /// <summary>Makes a run, which must succeed.</summary>
    /// <param name="folder">Of its outputs.</param>
    /// <param name="words">Its other options.</param>
    internal void Draw(string folder, params string[] words)
    {
        CommandLineRun run = CommandLineRun.Of([.. words, .. Options, "--output-dir", folder]);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
