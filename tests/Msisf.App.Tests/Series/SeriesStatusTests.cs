using Msisf.Adapters.Manifest;
using Msisf.App.Series;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Series;

public sealed class SeriesStatusTests : IDisposable
{
    private readonly SeriesFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Of_FramesOfARun_AreInTheOrderOfTheirSteps_WithTheirStates()
    {
        RunPlan plan = SeriesFolder.Plan("--fov 40", "d", "c", "b", "a", "e");
        _folder.Make(plan, 3, 1, 5);
        _folder.Write("b.png", "shorter");
        using (FrameLedger ledger = _folder.Open(plan))
        {
            ledger.Failed(SeriesFolder.Frame(plan, 4), "no light");
        }

        SeriesStatus status = Read();

        Assert.Equal(
            [
                (1, FrameState.Complete), (2, FrameState.Missing), (3, FrameState.Damaged), (4, FrameState.Failed),
                (5, FrameState.Complete),
            ],
            status.Frames.Select(frame => (frame.Expected.Step, frame.State)));
        Assert.Equal(
            ["not made yet", "b.png: 7 bytes long, 5 were written", "no light"], status.Incomplete.Select(frame => frame.Reason));
        Assert.Equal(2, status.CountOf(FrameState.Complete));
        Assert.False(status.IsComplete);
        Assert.Equal("2:4", status.StepsToMake().ToString());
    }

    [Fact]
    public void Of_AllFramesAreThere_IsComplete()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a", "b"), 1, 2);

        Assert.True(Read().IsComplete);
    }

    [Fact]
    public void Of_SeveralRuns_HasTheLastOneAtTheEnd_AndAmbiguousStepsAreRefused()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a", "b"), 2);
        _folder.Make(SeriesFolder.Plan("--fov 30", "x", "y"), 1);

        SeriesStatus status = Read();

        Assert.Equal(["a", "b", "x", "y"], status.Frames.Select(frame => frame.Expected.Name));
        Assert.Contains(
            "frames of several runs are not complete",
            Assert.Throws<BadInputException>(status.StepsToMake).Message,
            StringComparison.Ordinal);
    }

    /// <summary>A run with other settings expects frames of the same names: it says what differs, not only that something does.</summary>
    [Fact]
    public void Of_FrameOfOtherSettings_SaysWhichDiffer()
    {
        _folder.Make(SeriesFolder.Plan("--fov 40", "a"), 1);
        _folder.Make(SeriesFolder.Plan("--fov 30", "a"));

        FrameCheck check = Assert.Single(Read().Frames);

        Assert.Equal((FrameState.OtherSettings, "made with --fov 40, now 30"), (check.State, check.Reason));
    }

    private SeriesStatus Read() => SeriesStatus.Of(
        _folder.Path, _folder.Manifest, new FrameChecker(_folder.Path, CheckDepth.Lengths), CancellationToken.None);
}
