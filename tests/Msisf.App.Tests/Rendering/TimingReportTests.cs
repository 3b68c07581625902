using System.Text.Json;
using Msisf.App.Host;
using Msisf.App.Rendering;
using Xunit;

namespace Msisf.App.Tests.Rendering;

public sealed class TimingReportTests
{
    [Fact]
    public void Of_FramesMadeAndFound_CountsThemAndNamesAllPhases()
    {
        RunTimes times = new(TimeProvider.System);
        times.Add(Phase.PovRay, 1.23456);

        using JsonDocument json = JsonDocument.Parse(TimingReport.Of(
            times,
            [new FrameOutputs(["a.png"], 7, 2), new FrameOutputs(["b.png"], 5, 0), new FrameOutputs(["c.png"], 0, 0, WasThere: true)]));

        JsonElement report = json.RootElement;
        Assert.Equal((2, 1), (report.GetProperty("frames").GetInt32(), report.GetProperty("frames_there").GetInt32()));
        Assert.Equal((12, 2), (report.GetProperty("tiles").GetInt32(), report.GetProperty("patterns_made").GetInt32()));
        Assert.Equal(1.2346, report.GetProperty("pov_ray_s").GetDouble());
        Assert.Equal(0.0, report.GetProperty("start_up_s").GetDouble() - Math.Round(times.SecondsOf(Phase.StartUp), 4));
        Assert.Equal(
            Enum.GetValues<Phase>().Length + 1, // and the total
            report.EnumerateObject().Count(property => property.Name.EndsWith("_s", StringComparison.Ordinal)));
        Assert.True(report.GetProperty("peak_memory_bytes").GetInt64() > 1_000_000);
    }
}
