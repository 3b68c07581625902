using Microsoft.AspNetCore.Http;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The order of work.</summary>
public sealed class RenderQueueTests
{
    private const int Cores = 2;
    private const int MaxWaiting = 8;

    /// <summary>However many large images are drawn and wait, a small one is drawn at once; and more large ones are refused.</summary>
    [Fact]
    public async Task SmallWork_DoesNotWaitForLargeWork()
    {
        using RenderQueue queue = new(Cores, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        Task[] large = [.. Enumerable.Range(0, Cores + MaxWaiting).Select(_ => queue.RunAsync(isLarge: true, (_, stop) =>
        {
            end.Wait(stop);
            return true;
        }, default))];
        RefusedException refused = await Assert.ThrowsAsync<RefusedException>(() => queue.RunAsync(isLarge: true, (_, _) => true, default));

        bool isDrawn = await Within.Seconds(30.0, "small work", queue.RunAsync(isLarge: false, (_, _) => true, default));
        (int waiting, int running) = (queue.Waiting, queue.Running);
        end.Set();
        await Within.Seconds(30.0, "the large work", Task.WhenAll(large));

        Assert.True(isDrawn);
        Assert.Equal(StatusCodes.Status429TooManyRequests, refused.Status);
        Assert.Equal((MaxWaiting, Cores), (waiting, running));
    }

    [Fact]
    public async Task LargeWork_DoesNotWaitForSmallWork()
    {
        using RenderQueue queue = new(Cores, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        Task[] small = [.. Enumerable.Range(0, Cores + MaxWaiting).Select(_ => queue.RunAsync(isLarge: false, (_, stop) =>
        {
            end.Wait(stop);
            return true;
        }, default))];

        bool isDrawn = await Within.Seconds(30.0, "large work", queue.RunAsync(isLarge: true, (_, _) => true, default));
        end.Set();
        await Within.Seconds(30.0, "the small work", Task.WhenAll(small));

        Assert.True(isDrawn);
    }
}
