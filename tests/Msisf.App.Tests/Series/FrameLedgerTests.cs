using Msisf.Adapters.Manifest;
using Msisf.App.Series;
using Xunit;

namespace Msisf.App.Tests.Series;

public sealed class FrameLedgerTests : IDisposable
{
    private static readonly RunPlan Plan = SeriesFolder.Plan("--fov 40", "a", "b");

    private readonly SeriesFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Check_FrameIsMade_IsComplete_UntilAByteOfItChanges()
    {
        using FrameLedger ledger = _folder.Open(Plan);
        Assert.Equal((FrameState.Missing, "not made yet"), Check(ledger, 1));

        _folder.Make(ledger, 1, ".png", ".xml");
        Assert.Equal((FrameState.Complete, string.Empty), Check(ledger, 1));
        Assert.Equal([_folder["a.png"], _folder["a.xml"]], ledger.PathsOf(SeriesFolder.Frame(Plan, 1)));
        Assert.Equal((FrameState.Missing, "not made yet"), Check(ledger, 2));

        _folder.Write("a.xml", "A.xml");
        Assert.Equal((FrameState.Damaged, "a.xml: its checksum is not that of the file that was written"), Check(ledger, 1));
        File.Delete(_folder["a.xml"]);
        Assert.Equal((FrameState.Damaged, "a.xml: missing"), Check(ledger, 1));
        File.Delete(_folder["a.png"]);
        Assert.Equal((FrameState.Missing, "its files are gone"), Check(ledger, 1));
    }

    [Fact]
    public void Check_AnotherProcessMadeTheFrame_IsComplete()
    {
        using FrameLedger ledger = _folder.Open(Plan);
        using FrameLedger other = _folder.Open(SeriesFolder.Plan("--fov 40", "a", "b"));
        Assert.Equal(FrameState.Missing, Check(ledger, 2).State);

        _folder.Make(other, 2, ".png");

        Assert.Equal(FrameState.Complete, Check(ledger, 2).State);
        Assert.Single(_folder.Manifest.Runs);
    }

    [Fact]
    public void Check_FrameFailed_SaysTheCause_UntilItIsMade()
    {
        using FrameLedger ledger = _folder.Open(Plan);
        ledger.Failed(SeriesFolder.Frame(Plan, 1), "no light");
        Assert.Equal((FrameState.Failed, "no light"), Check(ledger, 1));

        _folder.Make(ledger, 1, ".png");
        Assert.Equal(FrameState.Complete, Check(ledger, 1).State);
    }

    [Fact]
    public void Check_WithOverwrite_TakesNoFrameOfBeforeForMade()
    {
        _folder.Make(Plan, 1);

        using FrameLedger ledger = _folder.Open(Plan, overwrite: true);
        Assert.Equal((FrameState.Missing, "not made yet"), Check(ledger, 1));
        _folder.Make(ledger, 1, ".png");
        Assert.Equal(FrameState.Complete, Check(ledger, 1).State);
    }

    /// <summary>The file "a.annotated.png" can be a part of the frame "a", or the image of the frame "a.annotated".</summary>
    [Theory]
    [InlineData("b", false)]
    [InlineData("a.annotated", true)]
    public void Made_FrameOfFewerFiles_RemovesTheOthers_ButNoneOfAnotherFrame(string second, bool isThere)
    {
        RunPlan plan = SeriesFolder.Plan("--rendering-annotation", "a", second);
        using (FrameLedger before = _folder.Open(plan))
        {
            _folder.Make(before, 1, ".png", ".xml", ".annotated.png");
            _folder.Make(before, 2, ".png");
        }

        using FrameLedger ledger = _folder.Open(SeriesFolder.Plan("--fov 40", "a"), overwrite: true);
        _folder.Make(ledger, 1, ".png");

        Assert.False(File.Exists(_folder["a.xml"]));
        Assert.Equal(isThere, File.Exists(_folder["a.annotated.png"]));
        Assert.True(File.Exists(_folder[$"{second}.png"]));
    }

    [Fact]
    public void Open_DamagedLines_AreTold_AndItsFramesMadeAgain()
    {
        _folder.Make(Plan, 1, 2);
        string path = _folder[ManifestFile.Name];
        string[] lines = File.ReadAllLines(path);
        File.WriteAllLines(path, [.. lines[..^1], lines[^1][..^9]]);

        using FrameLedger ledger = _folder.Open(Plan);

        Assert.Equal(
            [$"warning: {path}: 1 lines can't be read and are left out; frames whose lines they were are made again."], _folder.Log.Lines);
        Assert.Equal(FrameState.Complete, Check(ledger, 1).State);
        Assert.Equal(FrameState.Missing, Check(ledger, 2).State);
    }

    private static (FrameState State, string Reason) Check(FrameLedger ledger, int step)
    {
        FrameCheck check = ledger.Check(SeriesFolder.Frame(ledger.Plan, step));
        Assert.Equal(step, check.Expected.Step);
        return (check.State, check.Reason);
    }
}
