using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>The commands of docs/scanning-cameras.md run as they stand there, with fewer lines.</summary>
public sealed partial class ScanningPageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Page_ScanAndJitter_AreDrawnAndDiffer()
    {
        foreach (string line in Lines("--output-dir still"))
        {
            string[] words = [.. Words().Matches(line).Select(match => match.Value.Trim('\''))];
            if (words[0] == "printf")
            {
                _folder.Write(words[^1], words[1].Replace("\\n", "\n", StringComparison.Ordinal));
                continue;
            }

            Run(words, "512", "6", hasDetail: true);
        }

        byte[] still = File.ReadAllBytes(_folder["still/MoonSurfIllumSim_step_00001.png"]);
        byte[] shaken = File.ReadAllBytes(_folder["shaken/MoonSurfIllumSim_step_00001.png"]);
        Assert.True(still.Length > 1000);
        Assert.NotEqual(still, shaken);
    }

    [RequiresFact(Part.Ldem4, Part.LroNac)]
    public void Page_Nac_IsDrawn()
    {
        string[] words = [.. Words().Matches(Lines("--instrument LRO_LROCNACL").Single()).Select(match => match.Value)];
        words = [.. words.Select(word => word.Replace("lro/", $"{LroNac.Folder}/", StringComparison.Ordinal))];
        Run([.. words, "--output-dir", "nac"], "400", "4");
        PngPixels image = PngPixels.Read(_folder["nac/MoonSurfIllumSim_step_00001.png"]);
        Assert.Equal((5064, 4), (image.Width, image.Height));
    }

    /// <summary>Each band of a rig is the image of its preset alone.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Page_Wac_HasAnImageOfEachBand()
    {
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "scanning-cameras.md"));
        string rig = page[page.IndexOf("# wac.yaml", StringComparison.Ordinal)..];
        _folder.Write("wac.yaml", rig[..rig.IndexOf("```", StringComparison.Ordinal)].Replace(": 20,", ": 2,", StringComparison.Ordinal));
        string[] words = [.. Words().Matches(Lines("--rig wac.yaml").Single()).Select(match => match.Value.Trim('\''))];
        Run([.. words, "--output-dir", "bands"], "20", "2");
        string[] alone = ["--camera", "lroc-wac-689", "--framelets", "20", "--scan-period", "0.7", "--output-name", "wac_689"];
        int rigAt = Array.IndexOf(words, "--rig");
        int nameAt = Array.IndexOf(words, "--output-name");
        Run([.. words.Where((_, i) => i != rigAt && i != rigAt + 1 && i < nameAt), .. alone, "--output-dir", "alone"], "20", "2");
        Assert.Equal(5, Directory.GetFiles(_folder["bands"], "*.png").Length);
        Assert.Equal(File.ReadAllBytes(_folder["alone/wac_689.png"]), File.ReadAllBytes(_folder["bands/wac_689.png"]));
        Assert.NotEqual(File.ReadAllBytes(_folder["bands/wac_415.png"]), File.ReadAllBytes(_folder["bands/wac_689.png"]));
    }

    private static string[] Lines(string part)
    {
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "scanning-cameras.md"));
        string block = Blocks().Matches(page).Select(match => match.Groups[1].Value)
            .Single(text => text.Contains(part, StringComparison.Ordinal));
        return block.Replace("\\\n", " ", StringComparison.Ordinal).Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }

    private void Run(string[] words, string lines, string fewer, bool hasDetail = false)
    {
        string[] files = ["jitter.txt", "scanner.yaml", "still", "shaken", "nac", "wac.yaml", "bands", "alone"];
        CommandLineRun run = CommandLineRun.Of(
        [
            .. words.Skip(1).Where(word => hasDetail || word is not ("--refine" or "200"))
                .Select(word => word == lines ? fewer : files.Contains(word) ? _folder[word] : word),
            "--ldem", TestParts.Ldem4Label!, "--batch",
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    [GeneratedRegex(@"```sh\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Blocks();

    [GeneratedRegex(@"'[^']*'|[^\s']+")]
    private static partial Regex Words();
}
