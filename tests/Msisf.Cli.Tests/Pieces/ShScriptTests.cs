using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

[SupportedOSPlatform("linux")]
public sealed class ShScriptTests : IDisposable
{
    private readonly ConvertedScript _converted = new();

    public void Dispose() => _converted.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_ThreePieces_CallsTheProgramForEachInItsOrder()
    {
        string script = _converted.Convert("sh", "run.sh", "--pieces", "3", "--width", "64", "--pov-options", "", "--renderer", "povray");

        Assert.Equal(0, ConvertedScript.Run(script, _converted.FakeMsis()).ExitCode);

        Assert.Equal(["1:3", "4:6", "7:10"], _converted.PieceCalls());
        Assert.All(File.ReadAllLines(_converted.Calls), line =>
        {
            Assert.StartsWith($"--batch-file={script}.states.tab|--width=64|", line, StringComparison.Ordinal);
            Assert.Contains("|--pov-options||", line, StringComparison.Ordinal);
        });
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OddNames_ReachTheProgramUnchanged()
    {
        TemporaryFolder folder = _converted.Folder;
        string odd = folder["M\u00f6nd 'a' \"b\" $HOME;x 100% `id` \\ *"];
        string script = _converted.Convert(
            "sh", Path.Combine(odd, "run.sh"), "--pieces", "1", "--output-dir", odd, "--output-name=@'$x {step}");

        Assert.Equal(0, ConvertedScript.Run(script, _converted.FakeMsis()).ExitCode);

        string call = Assert.Single(File.ReadAllLines(_converted.Calls));
        Assert.StartsWith($"--batch-file={odd}/run.sh.states.tab|", call, StringComparison.Ordinal);
        Assert.Contains($"|--output-dir={odd}|", call, StringComparison.Ordinal);
        Assert.Contains("|--output-name=@'$x {step}|", call, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("0 0 0", 0, 3)]
    [InlineData("0 3 0", 3, 3)]
    [InlineData("3 0 2", 3, 3)]
    [InlineData("0 130 0", 130, 2)]
    public void Run_FailingPieces_GoesOnAndEndsWithTheWorstCode(string codes, int expected, int calls)
    {
        string script = _converted.Convert("sh", "run.sh", "--pieces", "3");
        string fake = _converted.FakeMsis($"set -- {codes}; shift $(($(wc -l <'{_converted.Calls}') - 1)); exit $1");

        Assert.Equal(expected, ConvertedScript.Run(script, fake).ExitCode);

        Assert.Equal(calls, File.ReadAllLines(_converted.Calls).Length);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_RelativePaths_BeginWhereTheCallWasMade()
    {
        string where = _converted.Folder["where"];
        string script = _converted.Convert("sh", "run.sh", "--pieces", "1", "--output-dir", "images");

        ConvertedScript.Run(script, _converted.FakeMsis($"pwd >'{where}'"));

        Assert.Equal(Directory.GetCurrentDirectory(), File.ReadAllText(where).TrimEnd());
        Assert.Contains("|--output-dir=images|", File.ReadAllText(_converted.Calls), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_SomeFrames_AreTheOnlyOnesMade()
    {
        string script = _converted.Convert("sh", "run.sh", "--pieces", "2", "--frames", "2:4,9");

        ConvertedScript.Run(script, _converted.FakeMsis());

        Assert.Equal(["2:3", "4,9"], _converted.PieceCalls());
    }
}
