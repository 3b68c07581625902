using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Xunit;

namespace Msisf.Core.Tests.Parallel;

public sealed class RecentUseTests
{
    [Fact]
    public void Note_LittleForSixteenFrames_MakesTheBufferSmaller()
    {
        RecentUse use = new();
        int length = 1_000_000;
        for (int frame = 1; frame < RecentUse.Frames; frame++)
        {
            Assert.False(use.Note(frame == 3 ? 100_000 : 10, ref length));
            Assert.Equal(1_000_000, length);
        }

        Assert.True(use.Note(10, ref length));
        Assert.Equal(125_000, length);
    }

    [Fact]
    public void Note_OneFrameOfSixteenNeedsHalf_LeavesTheBuffer()
    {
        RecentUse use = new();
        int length = 1_000_000;
        for (int frame = 0; frame < 5 * RecentUse.Frames; frame++)
        {
            Assert.False(use.Note(frame % RecentUse.Frames == 7 ? 500_000 : 10, ref length));
        }

        Assert.Equal(1_000_000, length);
    }

    [Fact]
    public void Note_SmallBuffer_IsLeft()
    {
        RecentUse use = new();
        int length = RecentUse.AlwaysKept;
        for (int frame = 0; frame < 5 * RecentUse.Frames; frame++)
        {
            Assert.False(use.Note(0, ref length));
        }
    }
}
