using System.Net;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Size, queue and time have limits, and who goes away ends the work for him.</summary>
public sealed class LimitTests
{
    /// <summary>Takes minutes, if it is not ended.</summary>
    private const string LongFrame = """
        {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 1024, "height": 1024, "samples": 256, "sun": "disc"}
        """;

    [RequiresFact(Part.Ldem4)]
    public async Task LargeImage_IsTooLarge()
    {
        using RunningServer server = await RunningServer.StartAsync((ServeOptions.MaxPixels, "3072"));

        Assert.Equal(HttpStatusCode.OK, await StatusAsync(server, $"{{{RunningServer.SmallFrame}}}")); // 64 x 48
        Assert.Equal(HttpStatusCode.RequestEntityTooLarge, await StatusAsync(server, LongFrame));
        await server.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task LongBody_IsTooLarge()
    {
        using RunningServer server = await RunningServer.StartAsync();

        Assert.Equal(HttpStatusCode.RequestEntityTooLarge, await StatusAsync(server, new string(' ', JsonBody.LargestRequest + 1)));
        await server.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task LongFrame_EndsAtTheTimeLimit()
    {
        using RunningServer server = await RunningServer.StartAsync((ServeOptions.TimeLimit, "1"));

        Assert.Equal(
            HttpStatusCode.ServiceUnavailable, await Within.Seconds(60.0, "the end of a long frame", StatusAsync(server, LongFrame)));
        await server.DisposeAsync();
    }

    /// <summary>As many frames as cores are drawn, one waits, and the next is told to come back; all end with their clients.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task FullQueue_IsTooManyRequests_AndClientsThatGoAwayEndTheirWork()
    {
        using RunningServer server = await RunningServer.StartAsync((ServeOptions.Queue, "1"));
        using CancellationTokenSource away = new();
        Task[] waiting = [.. Enumerable.Range(0, Environment.ProcessorCount + 1).Select(
            _ => server.PostAsync("/v1/render", LongFrame, cancellation: away.Token))];
        await server.WaitForMetricAsync("msisf_waiting 1");

        using HttpResponseMessage refused = await server.PostAsync("/v1/render", LongFrame);
        await away.CancelAsync();

        Assert.Equal(HttpStatusCode.TooManyRequests, refused.StatusCode);
        Assert.Equal(TimeSpan.FromSeconds(1), refused.Headers.RetryAfter!.Delta);
        await server.WaitForMetricAsync("msisf_running 0");
        Assert.Equal(HttpStatusCode.OK, await StatusAsync(server, $"{{{RunningServer.SmallFrame}}}"));
        foreach (Task task in waiting)
        {
            await Assert.ThrowsAnyAsync<OperationCanceledException>(() => task);
        }

        await server.DisposeAsync();
    }

    /// <summary>Requests are answered while all cores draw: threads for them don't come one by one.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Start_ThreadsForAnswers_AreMoreThanThoseThatDraw()
    {
        using RunningServer server = await RunningServer.StartAsync();

        ThreadPool.GetMinThreads(out int threads, out _);
        Assert.True(threads >= 5 * Environment.ProcessorCount, $"{threads} threads start at once");
        await server.DisposeAsync();
    }

    private static async Task<HttpStatusCode> StatusAsync(RunningServer server, string json)
    {
        using HttpResponseMessage answer = await server.PostAsync("/v1/render", json);
        return answer.StatusCode;
    }
}
