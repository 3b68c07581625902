using Msisf.Core.Ephemeris;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class SegmentTableTests
{
    [Fact]
    public void Find_TwoSegmentsHold_TheLaterLoadedWins()
    {
        FixedSegment early = new(10, 0, new TdbInterval(0.0, 100.0), default);
        FixedSegment late = new(10, 0, new TdbInterval(50.0, 60.0), default);
        SegmentTable table = new([early, late]);

        Assert.Same(late, table.Find(10, 55.0));
        Assert.Same(early, table.Find(10, 65.0));
    }

    [Fact]
    public void Find_OtherBodyOrTime_IsNull()
    {
        SegmentTable table = new([new FixedSegment(10, 0, new TdbInterval(0.0, 100.0), default)]);

        Assert.Null(table.Find(301, 50.0));
        Assert.Null(table.Find(10, 100.5));
    }

    [Fact]
    public void CoverOfChain_MoonOverBarycentre_IsWhatBothHold()
    {
        SegmentTable table = new(
        [
            new FixedSegment(301, 3, new TdbInterval(0.0, 100.0), default),
            new FixedSegment(3, 0, new TdbInterval(-50.0, 20.0), default),
            new FixedSegment(3, 0, new TdbInterval(80.0, 300.0), default),
        ]);

        Assert.Equal([new TdbInterval(0.0, 20.0), new TdbInterval(80.0, 100.0)], table.CoverOfChain(301).Intervals);
        Assert.Equal([new TdbInterval(0.0, 100.0)], table.CoverOf(301).Intervals);
    }

    [Fact]
    public void CoverOfChain_CentresInARing_IsEmpty()
    {
        SegmentTable table = new(
        [
            new FixedSegment(301, 3, new TdbInterval(0.0, 100.0), default),
            new FixedSegment(3, 301, new TdbInterval(0.0, 100.0), default),
        ]);

        Assert.Empty(table.CoverOfChain(301).Intervals);
    }
}
