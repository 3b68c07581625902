using Msisf.App.Host;
using Xunit;

namespace Msisf.App.Tests.Host;

public sealed class RunTimesTests
{
    private readonly RunTimes _times = new(TimeProvider.System);

    [Fact]
    public void Add_TimesOfSeveralThreads_AreSummedByPhase()
    {
        Parallel.For(0, 1000, _ => _times.Add(Phase.Xml, 0.25)); // a sum of powers of 2 is exact in any order
        _times.Add(Phase.Layers, 3.0);

        Assert.Equal(250.0, _times.SecondsOf(Phase.Xml));
        Assert.Equal(3.0, _times.SecondsOf(Phase.Layers));
        Assert.Equal(0.0, _times.SecondsOf(Phase.PovRay));
    }

    [Fact]
    public void Measure_WorkThatThrows_IsCounted()
    {
        Assert.Throws<InvalidOperationException>(() => _times.Measure(Phase.Draw, () => throw new InvalidOperationException()));

        Assert.True(_times.SecondsOf(Phase.Draw) > 0.0);
        Assert.Equal(7, _times.Measure(Phase.Output, () => 7));
    }

    /// <summary>A clock that was set back since the process began.</summary>
    [Fact]
    public void StartUp_ClockBeforeTheProcess_IsNone()
    {
        RunTimes times = new(new ClockOf2010());

        Assert.Equal(0.0, times.SecondsOf(Phase.StartUp));
        Assert.True(_times.SecondsOf(Phase.StartUp) > 0.0);
        Assert.True(_times.TotalSeconds >= _times.SecondsOf(Phase.StartUp));
    }

    private sealed class ClockOf2010 : TimeProvider
    {
        public override DateTimeOffset GetUtcNow() => new(2010, 4, 3, 0, 0, 0, TimeSpan.Zero);
    }
}
