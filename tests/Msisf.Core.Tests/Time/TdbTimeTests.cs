using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Time;

public sealed class TdbTimeTests
{
    [Fact]
    public void Plus_SmallSteps_AreKeptAndComeBack()
    {
        TdbTime time = 599_616_069.1839;
        TdbTime later = time + 1e-9;

        Assert.Equal(time.Seconds, later.Seconds); // a double steps by 1.2e-7 s
        Assert.Equal(1e-9, later - time, 1e-24);
        Assert.True(later > time && time < later && later >= time && !(later <= time));
        Assert.Equal(time, later + -1e-9);
    }

    [Fact]
    public void Plus_AcrossARounding_KeepsTheNearestDoubleFirst()
    {
        TdbTime time = 599_616_069.0;
        for (int i = 0; i < 1000; i++)
        {
            time += 1e-8;
        }

        Assert.Equal(599_616_069.00001, time.Seconds);
        Assert.Equal(1e-5, time - 599_616_069.0, 1e-18);
    }
}
