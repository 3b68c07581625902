using Msisf.App.Host;
using Xunit;

namespace Msisf.App.Tests.Host;

public sealed class FractionProgressTests
{
    [Fact]
    public void Report_FractionsOfSeveralThreads_AdvancesOncePerStepAndNeverBack()
    {
        Counter counter = new();
        FractionProgress progress = new(counter, "synthesis");

        progress.Report(0.5);
        Assert.Equal(50, counter.Steps);
        progress.Report(0.2); // of a thread that is behind
        Assert.Equal(50, counter.Steps);
        Parallel.For(51, 101, hundredth => progress.Report(hundredth / 100.0));

        Assert.Equal(FractionProgress.Steps, counter.Steps);
        Assert.Equal("synthesis", counter.Name);
    }

    private sealed class Counter : IRunProgress
    {
        public int Steps { get; private set; }

        public string? Name { get; private set; }

        public void Advance(string name) => (Steps, Name) = (Steps + 1, name);

        public void Dispose()
        {
        }
    }
}
