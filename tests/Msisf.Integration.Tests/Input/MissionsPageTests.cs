using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>The commands of docs/missions.md run as they stand there, on files that the page's own recipe made.</summary>
public sealed partial class MissionsPageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4, Part.Python, Part.Numpy)]
    public void Page_OwnPropagator_MakesAnOemThatIsDrawnAndWritten()
    {
        File.WriteAllText(
            _folder["recipe.py"], Blocks("python").Single(block => block.Contains("CCSDS_OEM_VERS", StringComparison.Ordinal)));
        ChildRun.Of(TestParts.Python!, ["-B", _folder["recipe.py"]], _folder.Path).Succeeded();

        Run(Command("--output-dir own"), "--width", "64", "--height", "64", "--frames", "2");
        Run(Command("--format spice --to kernels"));
        Assert.True(new FileInfo(_folder["own/MoonSurfIllumSim_step_00002.png"]).Length > 1000);
        Assert.True(new FileInfo(_folder["kernels/states.bsp"]).Length > 145 * 56);

        Run(
        [
            "states", "--format", "oem", "--to", _folder.Path, "--oem", _folder["orbit.oem"], "--every", "300", "--ldem",
            TestParts.Ldem4Label!,
        ]);
        foreach (string line in Blocks("sh").Single(block => block.Contains("states.aem", StringComparison.Ordinal)).TrimEnd().Split('\n'))
        {
            string table = Run(line);
            Assert.Equal(3 + 13, table.TrimEnd().Split('\n').Length); // three lines of names, twelve hours
        }
    }

    [RequiresFact(Part.Ldem4, Part.Artemis)]
    public void Page_Artemis_IsDrawn()
    {
        string[] words = Words(Command("--output-dir artemis"));
        words[Array.FindIndex(words, word => word.EndsWith(".gz", StringComparison.Ordinal))] = TestParts.ArtemisOem!;

        Run([.. words, "--width", "64", "--height", "64", "--frames", "286", "--ldem", TestParts.Ldem4Label!]);

        Assert.True(new FileInfo(_folder["artemis/MoonSurfIllumSim_step_00286.png"]).Length > 1000);
    }

    [RequiresFact(Part.LroNac, Part.Ldem4)]
    public void Page_Lro_ListsKernelsAndIsDrawn()
    {
        string table = Run(OfLro("msis kernels "));
        Run([.. OfLro("--instrument LRO_LROCNACL"), "--output-dir", _folder["lro"], "--ldem", TestParts.Ldem4Label!]);

        Assert.Contains("LRO_SPACECRAFT (-85000)", table, StringComparison.Ordinal);
        Assert.True(new FileInfo(Directory.GetFiles(_folder["lro"], "*.png").Single()).Length > 10_000);
    }

    private static string[] OfLro(string part) =>
    [
        .. Command(part).Split(' ', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(
            word => word.StartsWith("lro/", StringComparison.Ordinal) ? Path.Combine(LroNac.Folder, word[4..]) : word),
    ];

    private static string Command(string part) => Blocks("sh")
        .SelectMany(block => block.Replace("\\\n", " ", StringComparison.Ordinal).Split('\n'))
        .Single(line => line.Contains(part, StringComparison.Ordinal));

    private string[] Words(string line) =>
    [
        .. line.Split(' ', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(
            word => word is "own" or "artemis" or "kernels" || word.EndsWith(".oem", StringComparison.Ordinal)
                || word.EndsWith(".aem", StringComparison.Ordinal) ? _folder[word] : word),
    ];

    private string Run(string line, params string[] more) => Run([.. Words(line), .. more, "--ldem", TestParts.Ldem4Label!]);

    private static string Run(string[] words)
    {
        CommandLineRun run = CommandLineRun.Of(words);
        Assert.True(run.ExitCode == 0, run.Error);
        return run.Output;
    }

    private static string[] Blocks(string language) =>
    [
        .. Block().Matches(File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "missions.md")))
            .Where(match => match.Groups[1].Value == language).Select(match => match.Groups[2].Value),
    ];

    [GeneratedRegex("```([a-z]*)\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Block();
}
