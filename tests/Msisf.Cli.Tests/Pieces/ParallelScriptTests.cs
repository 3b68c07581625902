using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary>The script by the real GNU parallel.</summary>
[SupportedOSPlatform("linux")]
public sealed class ParallelScriptTests : IDisposable
{
    private readonly ConvertedScript _converted = new();

    public void Dispose() => _converted.Dispose();

    [RequiresFact(Part.Ldem4, Part.Parallel)]
    public void Run_FailedPiece_IsTheOnlyOneThatRunsAgain()
    {
        string script = _converted.Convert("parallel", "M\u00f6nd 'a' $x/run \"b\".sh", "--pieces", "4");
        string second = _converted.Folder["second"];
        string fake = _converted.FakeMsis($"case \"$*\" in *' 3:5') [ -e '{second}' ] || exit 3;; esac");

        Assert.Equal(0, ConvertedScript.Run(script, fake, "2").ExitCode);
        Assert.Equal(["1:2", "3:5", "6:7", "8:10"], _converted.PieceCalls().Order(StringComparer.Ordinal));
        File.Delete(_converted.Calls);
        File.WriteAllText(second, string.Empty);
        Assert.Equal(0, ConvertedScript.Run(script, fake, "2").ExitCode);

        Assert.Equal(["3:5"], _converted.PieceCalls());
        Assert.Equal("verify|output|", File.ReadLines(_converted.Calls).Last());
    }

    [RequiresFact(Part.Ldem4, Part.Parallel)]
    public void Run_FramesMissingThoughAllPiecesEndedWell_LooksAtAllNextTime()
    {
        string script = _converted.Convert("parallel", "run.sh", "--pieces", "2");
        string fake = _converted.FakeMsis("[ \"$1\" != verify ] || exit 5");

        Assert.Equal(5, ConvertedScript.Run(script, fake).ExitCode);
        Assert.Equal(5, ConvertedScript.Run(script, fake).ExitCode);

        Assert.Equal(["1:5", "1:5", "6:10", "6:10"], _converted.PieceCalls().Order(StringComparer.Ordinal));
    }

    [RequiresFact(Part.Ldem4, Part.Parallel)]
    public void Convert_Again_ForgetsThePiecesOfTheScriptBefore()
    {
        string fake = _converted.FakeMsis();
        ConvertedScript.Run(_converted.Convert("parallel", "run.sh", "--pieces", "2"), fake);
        File.Delete(_converted.Calls);

        ConvertedScript.Run(_converted.Convert("parallel", "run.sh", "--pieces", "3"), fake);

        Assert.Equal(["1:3", "4:6", "7:10"], _converted.PieceCalls().Order(StringComparer.Ordinal));
    }

    [RequiresFact(Part.Ldem4, Part.Parallel)]
    public void Run_Pieces_ShareTheCores()
    {
        string threads = _converted.Folder["threads"];
        string script = _converted.Convert("parallel", "run.sh", "--pieces", "2");
        string fake = _converted.FakeMsis($"[ \"$1\" = verify ] || echo \"$DOTNET_PROCESSOR_COUNT\" >>'{threads}'");

        ConvertedScript.Run(script, fake, "1");

        string cores = ChildRun.Of("nproc", [], "/").Output.Trim();
        Assert.Equal([cores, cores], File.ReadAllLines(threads));
        Assert.All(
            File.ReadAllLines(_converted.Calls).Take(2),
            line => Assert.Contains($"|--jobs|{cores}|--frames|", line, StringComparison.Ordinal));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("0")]
    [InlineData("two")]
    [InlineData("-1")]
    public void Run_WrongNumberOfJobs_IsRefused(string jobs)
    {
        string script = _converted.Convert("parallel", "run.sh", "--pieces", "2");

        ChildRun run = ConvertedScript.Run(script, _converted.FakeMsis(), jobs);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("usage", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(_converted.Calls));
    }
}
