using Msisf.Core.Render.Indirect;
using Xunit;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>How many samples groups of points get.</summary>
public sealed class TrialGridTests
{
    /// <summary>
    /// n samples leave an error of d^2 / n; with least work n grows as d. A group that may not have as many as that leaves the others
    /// with what they would have.
    /// </summary>
    [Theory]
    [InlineData(20.0, 10240, 20480)]
    [InlineData(1000.0, 65536, 0)]
    public void EffortFor_GroupWithTheMostSamples_AsksNoMoreOfOthers(double unsure, int samples, int next)
    {
        TrialGrid trials = new(groups: 8, strips: 1);
        trials[0, 0] = new Trial(1, default, default, 0.0, new Deviation(unsure, samples), 0.1);
        trials[0, 7] = new Trial(1, default, default, 0.0, new Deviation(1.0, 512), 0.1);
        trials.LookAround();

        double allowed = (unsure + 1.0) / 1024.0; // with 1024 samples for each unit of their deviation
        double effort = trials.EffortFor(allowed);

        Assert.InRange(trials.Known(0, 7).Next(effort).Near, 1023, 1026); // the effort is known to a thousandth
        Assert.InRange(trials.Known(0, 0).Next(effort).Near, next, next * 1.001);
        Assert.Equal(0.0, trials.EffortFor(unsure * unsure));
    }
}
