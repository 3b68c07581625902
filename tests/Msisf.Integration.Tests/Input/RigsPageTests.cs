using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>The rig file and the command of docs/cameras.md as they stand there, without invented detail.</summary>
public sealed partial class RigsPageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Left and right see the same ground, shifted by what 40 m are; what looks down is no shifted view of it.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Page_Rig_IsDrawn()
    {
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "cameras.md"));
        string rigs = page[page.IndexOf("## Several cameras on one body", StringComparison.Ordinal)..];
        string[] blocks = [.. Blocks().Matches(rigs).Select(match => match.Groups[1].Value)];
        string rig = _folder.Write("lander.yaml", blocks[0]);
        string[] words = [.. Words().Matches(blocks[1].Replace("\\\n", " ", StringComparison.Ordinal))
            .Select(match => match.Value.Trim('\''))];
        CommandLineRun run = CommandLineRun.Of(
        [
            .. words.Skip(1).Select(word => word == "lander.yaml" ? rig : word).Where(word => word is not ("--refine" or "200")),
            "--ldem", TestParts.Ldem4Label!, "--batch", "--output-dir", _folder["out"], "--layers", "depth", "--layers-format", "npy",
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(
            ["descent_1", "left_1", "right_1"],
            Directory.GetFiles(_folder["out"], "*.png").Select(path => Path.GetFileNameWithoutExtension(path)).Order());
        (double[] left, double[] right) = (MiddleRow("left"), MiddleRow("right"));

        // Beside each other by 40 m at 40 degrees over 480 px: so many px at this depth, where the ground is plain.
        double shift = 240.0 / Math.Tan(double.DegreesToRadians(20.0)) * 40.0 / left[240];
        Assert.InRange(shift, 1.0, 100.0);
        Assert.Equal(left[240], right[(int)(240 - shift)], 0.05 * left[240]);
    }

    private double[] MiddleRow(string camera)
    {
        byte[] file = File.ReadAllBytes(_folder[$"out/{camera}_1.depth.npy"]);
        int head = 10 + BitConverter.ToUInt16(file, 8);
        return [.. Enumerable.Range(0, 480).Select(x => BitConverter.ToDouble(file, head + (8 * ((180 * 480) + x))))];
    }

    [GeneratedRegex(@"```(?:yaml|sh)\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Blocks();

    [GeneratedRegex(@"'[^']*'|[^\s']+")]
    private static partial Regex Words();
}
