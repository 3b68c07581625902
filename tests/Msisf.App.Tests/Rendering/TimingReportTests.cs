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
            Enum.GetValues<Phase>().Length + 2, // what is in none, and the total
            report.EnumerateObject().Count(property => property.Name.EndsWith("_s", StringComparison.Ordinal)));
        Assert.True(report.GetProperty("peak_memory_bytes").GetInt64() > 1_000_000);
    }

    [Fact]
    public void OtherSeconds_PartsOneAfterTheOther_AreTheRestOfTheTotal()
    {
        RunTimes times = new(TimeProvider.System);
        times.BeginRun();
        double parts = times.SecondsOf(Phase.StartUp) + times.SecondsOf(Phase.Options);
        double rest = times.OtherSeconds(parts + 2.0);

        Assert.True(times.SecondsOf(Phase.Options) > 0.0);
        Assert.Equal(2.0, rest, 1e-12); // rounding
        times.Add(Phase.Parse, 1000.0); // a part of POV-Ray's
        Assert.Equal(rest, times.OtherSeconds(parts + 2.0));
        times.Add(Phase.Draw, 1000.0);
        Assert.Equal(0.0, times.OtherSeconds(parts + 2.0));
        Assert.True(times.TotalSeconds >= parts);
    }
}
