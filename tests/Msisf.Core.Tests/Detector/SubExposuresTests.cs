using Msisf.Core.Detector;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class SubExposuresTests
{
    /// <summary>6 s in three parts of 2 s: their middles are 2 s apart.</summary>
    [Fact]
    public void TimeOf_Parts_AreTheirMiddles()
    {
        SubExposures exposures = new(3, 6.0);
        Assert.Equal([-2.0, 0.0, 2.0], Enumerable.Range(0, 3).Select(exposures.TimeOf));
        Assert.Equal(0.0, exposures.TimeOf(exposures.Middle));
        Assert.Equal(1.0 / 3.0, exposures.Weight);
    }
}
