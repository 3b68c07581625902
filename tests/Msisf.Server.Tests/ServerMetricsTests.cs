using System.Globalization;
using Msisf.App.Host;
using Msisf.App.Serving;
using Xunit;

namespace Msisf.Server.Tests;

public sealed class ServerMetricsTests
{
    private const int Kinds = 3000;

    /// <summary>/metrics is asked for while requests end in ways that were not counted before.</summary>
    [Fact]
    public async Task Text_WhileNewKindsOfAnswersAreCounted_IsMade()
    {
        ProgramHost host = ServerHost.Create(TextWriter.Null, new ConsoleLog(TextWriter.Null), TimeProvider.System, static _ => null);
        using RenderQueue queue = new(cores: 1, maxWaiting: 1, TimeSpan.FromSeconds(1.0));
        using RenderSessions sessions = new(host);
        using ServerMetrics metrics = new(queue, sessions, TimeProvider.System);

        Task counting = Task.Run(() =>
        {
            for (int status = 0; status < Kinds; status++)
            {
                metrics.Answered("/metrics", status);
            }
        });
        while (!counting.IsCompleted)
        {
            _ = metrics.Text();
        }

        await counting;
        Assert.Contains(
            string.Create(CultureInfo.InvariantCulture, $"status=\"{Kinds - 1}\"}} 1\n"), metrics.Text(), StringComparison.Ordinal);
    }

    /// <summary>Dashboards ask for these names.</summary>
    [Fact]
    public void Text_HasEveryInstrument_WithItsTypeAndClasses()
    {
        ProgramHost host = ServerHost.Create(TextWriter.Null, new ConsoleLog(TextWriter.Null), TimeProvider.System, static _ => null);
        using RenderQueue queue = new(cores: 1, maxWaiting: 1, TimeSpan.FromSeconds(1.0));
        using RenderSessions sessions = new(host);
        using ServerMetrics other = new(queue, sessions, TimeProvider.System);
        using ServerMetrics metrics = new(queue, sessions, TimeProvider.System);
        other.Answered("/elsewhere", 200);
        string before = metrics.Text();

        metrics.Answered("/v1/sun", 404);
        metrics.Answered("/v1/render", 200);
        metrics.Answered("/v1/render", 200);
        metrics.StreamsChanged(1);
        metrics.StreamsChanged(1);
        metrics.StreamsChanged(-1);
        metrics.FrameDrawn(TimeSpan.FromMilliseconds(5.0)); // on a border, to which the class reaches
        metrics.FrameDrawn(TimeSpan.FromMilliseconds(50.0));
        metrics.FrameDrawn(TimeSpan.FromSeconds(20.0));
        string text = metrics.Text();

        Assert.Equal(
            [
                "msisf_requests_total counter", "msisf_frame_seconds histogram", "msisf_waiting gauge", "msisf_running gauge",
                "msisf_streams gauge", "msisf_sessions gauge", "process_resident_memory_bytes gauge", "process_cpu_seconds_total counter",
                "dotnet_allocated_bytes_total counter", "dotnet_collections_total counter", "process_uptime_seconds gauge",
            ],
            text.Split('\n').Where(line => line.StartsWith("# TYPE ", StringComparison.Ordinal)).Select(line => line[7..]));
        Assert.Contains("\nmsisf_frame_seconds_bucket{le=\"+Inf\"} 0\n", before, StringComparison.Ordinal);
        Assert.Contains("\nmsisf_streams 0\n", before, StringComparison.Ordinal);
        Assert.Contains(
            "msisf_requests_total{path=\"/v1/render\",status=\"200\"} 2\nmsisf_requests_total{path=\"/v1/sun\",status=\"404\"} 1\n# HELP",
            text,
            StringComparison.Ordinal);
        Assert.Contains("\nmsisf_streams 1\n", text, StringComparison.Ordinal);
        Assert.Contains(
            "_bucket{le=\"0.005\"} 1\nmsisf_frame_seconds_bucket{le=\"0.01\"} 1\n", text, StringComparison.Ordinal);
        Assert.Contains(
            "_bucket{le=\"0.06\"} 2\nmsisf_frame_seconds_bucket{le=\"0.1\"} 2\n", text, StringComparison.Ordinal);
        Assert.Contains(
            "_bucket{le=\"10\"} 2\nmsisf_frame_seconds_bucket{le=\"+Inf\"} 3\n"
                + "msisf_frame_seconds_sum 20.055\nmsisf_frame_seconds_count 3\n",
            text,
            StringComparison.Ordinal);
        Assert.DoesNotContain("elsewhere", text, StringComparison.Ordinal);
        Assert.True(Environment.WorkingSet / 2 < Number(text, "process_resident_memory_bytes"));
        Assert.True(Number(text, "process_cpu_seconds_total") > 0.0);
        Assert.Equal(GC.CollectionCount(2), Number(text, "dotnet_collections_total{generation=\"2\"}"));
    }

    private static double Number(string text, string name) => double.Parse(
        text.Split('\n').First(line => line.StartsWith($"{name} ", StringComparison.Ordinal)).Split(' ')[1], CultureInfo.InvariantCulture);
}
