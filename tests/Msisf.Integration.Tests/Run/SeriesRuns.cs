using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs of six small frames of an orbit, in folders of the test's own.</summary>
public abstract class SeriesRuns : IDisposable
{
    protected const int Frames = 6;

    private protected TemporaryFolder Folder { get; } = new();

    public void Dispose()
    {
        Folder.Dispose();
        GC.SuppressFinalize(this);
    }

    private protected string Image(string folder, int step) => Path.Combine(Folder[folder], $"MoonSurfIllumSim_step_{step:00000}.png");

    private protected CommandLineRun Run(string folder, params string[] more) => CommandLineRun.Of(
    [
        .. Arguments(folder), .. more.Contains("--reflectance") ? [] : (string[])["--reflectance", "lambert"],
        .. more.Contains("--ldem") ? [] : (string[])["--ldem", TestParts.Ldem4Label!], .. more,
    ]);

    private protected string[] Arguments(string folder) =>
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.001:55289.005]", "--renderer",
        "native", "--width", "24", "--height", "16", "--grid", "8", "--ephemeris", "builtin", "--output-dir", Folder[folder], "--batch",
    ];

    private protected CommandLineRun Single(string folder, params string[] more) => CommandLineRun.Of(
    [
        "--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", "--renderer", "native",
        "--reflectance", "lambert", "--width", "24",
        "--height", "16", "--grid", "8", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir", Folder[folder],
        "--batch", .. more,
    ]);

    private protected string[] NamesIn(string folder) =>
    [
        .. Directory.EnumerateFiles(Folder[folder]).Select(Path.GetFileName).OfType<string>()
            .Where(name => name[0] != '.').Order(StringComparer.Ordinal),
    ];

    private protected CommandLineRun Look(string command, string folder, params string[] more) =>
        CommandLineRun.Of([command, Folder[folder], .. more]);

    private protected void AssertSameBytes(string folder, string other, int files)
    {
        string[] names = NamesIn(folder);
        Assert.Equal(files, names.Length);
        Assert.Equal(names, NamesIn(other));
        Assert.All(
            names,
            name => Assert.Equal(
                File.ReadAllBytes(Path.Combine(Folder[folder], name)), File.ReadAllBytes(Path.Combine(Folder[other], name))));
    }
}
