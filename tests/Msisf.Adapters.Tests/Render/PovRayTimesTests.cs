using Msisf.Adapters.Render;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public sealed class PovRayTimesTests
{
    /// <summary>Printed by POV-Ray 3.7.0.10.</summary>
    private const string Printed =
        """
        Parser Time
          Parse Time:       0 hours  0 minutes  3 seconds (3.142 seconds)
                      using 1 thread(s) with 3.100 CPU-seconds total
          Bounding Time:    0 hours  0 minutes  0 seconds (0.250 seconds)
        Render Time:
          Photon Time:      No photons
          Trace Time:       0 hours  1 minutes  1 seconds (61.500 seconds)
                      using 2 thread(s) with 0.015 CPU-seconds total
        """;

    [Fact]
    public void Read_Statistics_TakesParseAndTraceTime() =>
        Assert.Equal(new PovRayTimes(3.142, 61.5), PovRayTimes.Read(Printed));

    [Fact]
    public void Read_NoStatistics_SaysNothing() =>
        Assert.Equal(new PovRayTimes(null, null), PovRayTimes.Read("POV-Ray finished"));
}
