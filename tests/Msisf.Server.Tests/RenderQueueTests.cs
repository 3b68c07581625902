using System.Collections.Concurrent;
using Microsoft.AspNetCore.Http;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The order of work.</summary>
public sealed class RenderQueueTests
{
    private const int Cores = 2;
    private const int MaxWaiting = 8;
    private static readonly Demand Small = new("a", 1024 * 1024, IsLarge: false);
    private static readonly Demand Large = new("a", 4096 * 4096, IsLarge: true);

    /// <summary>However many large images are drawn and wait, a small one is drawn at once; and more large ones are refused.</summary>
    [Fact]
    public async Task SmallWork_DoesNotWaitForLargeWork()
    {
        using RenderQueue queue = new(Cores, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        Task[] large = Blocking(queue, Large, end);
        RefusedException refused = await Assert.ThrowsAsync<RefusedException>(() => queue.RunAsync(Large, (_, _) => true, default));

        bool isDrawn = await Within.Seconds(30.0, "small work", queue.RunAsync(Small, (_, _) => true, default));
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
        Task[] small = Blocking(queue, Small, end);

        bool isDrawn = await Within.Seconds(30.0, "large work", queue.RunAsync(Large, (_, _) => true, default));
        end.Set();
        await Within.Seconds(30.0, "the small work", Task.WhenAll(small));

        Assert.True(isDrawn);
    }

    /// <summary>While a client has all places and as many requests wait as may, two others are drawn at once.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task OthersWork_DoesNotWaitForThatOfOneClient(bool isLarge)
    {
        using RenderQueue queue = new(Cores, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        using ManualResetEventSlim endOfOther = new();
        Demand demand = isLarge ? Large : Small;
        Task[] busy = Blocking(queue, demand, end);
        TaskCompletionSource isThere = new();
        Task other = queue.RunAsync(demand with { Client = "b" }, (_, stop) =>
        {
            isThere.SetResult();
            endOfOther.Wait(stop);
            return true;
        }, default);

        await Within.Seconds(30.0, "the other client's work", isThere.Task);
        bool isThird = await Within.Seconds(
            30.0, "the third client's work", queue.RunAsync(demand with { Client = "c" }, (_, _) => true, default));
        bool isDone = other.IsCompleted || busy.Any(task => task.IsCompleted);
        endOfOther.Set();
        end.Set();
        await Within.Seconds(30.0, "all work", Task.WhenAll([other, .. busy]));

        Assert.True(isThird);
        Assert.False(isDone, "it was drawn only after others");
    }

    /// <summary>One core, whose spare place stays taken: what waits takes turns, the longest wait and the least work.</summary>
    [Fact]
    public async Task WaitingWork_IsDoneByTurnsOfTheLongestWaitAndTheLeastWork()
    {
        using RenderQueue queue = new(cores: 1, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim endOfFirst = new();
        using ManualResetEventSlim endOfSpare = new();
        ConcurrentQueue<string> order = [];
        Task first = Named("a", 700, "first", endOfFirst);
        Task spare = Named("b", 700, "spare", endOfSpare);
        await Within.Seconds(30.0, "both places", () => queue.Running == 2);
        Task[] waiting =
        [
            Named("a", 900, "a900", null), Named("a", 800, "a800", null), Named("a", 500, "a500", null), Named("c", 1000, "c1000", null),
            Named("a", 400, "a400", null),
        ];
        int waited = queue.Waiting;

        endOfFirst.Set();
        await Within.Seconds(30.0, "all but the spare place's work", Task.WhenAll([first, .. waiting]));
        string[] done = [.. order];
        endOfSpare.Set();
        await Within.Seconds(30.0, "the spare place's work", spare);

        Assert.Equal(waiting.Length, waited);
        Assert.Equal(["first", "a900", "a400", "a800", "a500", "c1000"], done);

        Task Named(string client, int thousands, string name, ManualResetEventSlim? end) => queue.RunAsync(
            new Demand(client, 1000 * thousands, IsLarge: false),
            (_, stop) =>
            {
                end?.Wait(stop);
                order.Enqueue(name);
                return true;
            },
            default);
    }

    /// <summary>A client that can't be told from a busy one has its smallest images at once.</summary>
    [Fact]
    public async Task SmallestWork_OfABusyClient_IsDoneAtOnce()
    {
        using RenderQueue queue = new(Cores, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        Task[] busy = Blocking(queue, Small, end);

        bool isDrawn = await Within.Seconds(
            30.0, "the smallest work", queue.RunAsync(Small with { Samples = 256 * 256 }, (_, _) => true, default));
        end.Set();
        await Within.Seconds(30.0, "all work", Task.WhenAll(busy));

        Assert.True(isDrawn);
    }

    [Fact]
    public async Task WaitingWork_WhoseClientLeaves_TakesNoPlace()
    {
        using RenderQueue queue = new(cores: 1, MaxWaiting, TimeSpan.FromMinutes(1));
        using ManualResetEventSlim end = new();
        using CancellationTokenSource gone = new();
        Task first = queue.RunAsync(Small, (_, stop) => end.Wait(TimeSpan.FromMinutes(1), stop), default);
        Task<bool> left = queue.RunAsync(Small, (_, _) => true, gone.Token);
        Task<bool> stays = queue.RunAsync(Small, (_, _) => true, default);

        await gone.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => left);
        int waiting = queue.Waiting;
        end.Set();

        Assert.True(await Within.Seconds(30.0, "the one that stays", stays));
        await first;
        Assert.Equal(1, waiting);
    }

    /// <summary>As many requests of a client as may be there, which end when they are told to.</summary>
    private static Task[] Blocking(RenderQueue queue, Demand demand, ManualResetEventSlim end) =>
    [
        .. Enumerable.Range(0, Cores + MaxWaiting).Select(_ => queue.RunAsync(demand, (_, stop) =>
        {
            end.Wait(stop);
            return true;
        }, default)),
    ];
}
