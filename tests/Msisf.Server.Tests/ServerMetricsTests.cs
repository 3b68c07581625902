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
        ServerMetrics metrics = new(queue, sessions, TimeProvider.System);

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
}
