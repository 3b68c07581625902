using System.Globalization;
using System.Net;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>One client asks for more than the server can draw at once; others notice little of it.</summary>
public sealed class FairnessTests(RunningServer server) : IClassFixture<RunningServer>
{
    /// <summary>One that is drawn at once and as many as may wait: more than this would be refused.</summary>
    private const int Requests = MostWaiting + 1;

    private const int MostWaiting = 64;

    /// <summary>Longer than between two connections that a program opens at once.</summary>
    private static readonly TimeSpan BetweenPrograms = TimeSpan.FromSeconds(1.0);

    /// <summary>Requests of the busy client that may be answered before the other's: those that are drawn, and a turn more.</summary>
    private static readonly int MostBefore = 3 * Environment.ProcessorCount;

    [RequiresTheory(Part.Ldem4)]
    [InlineData("other", 1024, 1024)] // the same image: by its name
    [InlineData(null, 64, 64)] // a small one, of the same address
    public async Task ManyRequestsOfOne_LetTheOthersBeAnsweredFirst(string? name, int width, int height)
    {
        using HttpClient busy = new() { BaseAddress = server.Client.BaseAddress };
        using CancellationTokenSource enough = new();
        (await AskAsync(busy, null, 16, 16, default)).Dispose(); // the model is open, and all is compiled
        int answered = 0;
        Task[] many =
        [
            .. Enumerable.Range(0, Requests)
                .Select(_ => AskAsync(busy, name is null ? null : "busy", 1024, 1024, enough.Token))
                .Select(asked => asked.ContinueWith(
                    answer => answer.IsCompletedSuccessfully ? Interlocked.Increment(ref answered) : 0, TaskScheduler.Default)),
        ];
        await UntilMostWaitAsync();
        int before = Volatile.Read(ref answered);

        using HttpResponseMessage other = await AskAsync(server.Client, name, width, height, default);
        int meanwhile = Volatile.Read(ref answered) - before;
        await enough.CancelAsync();
        await Task.WhenAll(many);

        Assert.Equal(HttpStatusCode.OK, other.StatusCode);
        Assert.InRange(meanwhile, 0, MostBefore);
    }

    /// <summary>
    /// Another program does not wait for its place while one has all of its own: neither by name nor, since it connects later, without;
    /// neither for small images nor for large ones, of which a drawing takes longer.
    /// </summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("other", 1024)]
    [InlineData(null, 1024)]
    [InlineData("other", 1400)]
    [InlineData(null, 1400)]
    public async Task AnotherProgram_WaitsForAPartOfADrawingOnly(string? name, int side)
    {
        using HttpClient busy = new() { BaseAddress = server.Client.BaseAddress };
        using HttpClient other = new() { BaseAddress = server.Client.BaseAddress };
        using CancellationTokenSource enough = new();
        Task<HttpResponseMessage>[] many =
        [
            .. Enumerable.Range(0, Requests).Select(_ => AskAsync(busy, name is null ? null : "busy", side, side, enough.Token)),
        ];
        await UntilMostWaitAsync();
        await Task.Delay(BetweenPrograms);

        using HttpResponseMessage first = await AskAsync(other, name, side, side, default);
        using HttpResponseMessage second = await AskAsync(other, name, side, side, default);
        await enough.CancelAsync();
        await Task.WhenAny(Task.WhenAll(many)); // most are cancelled

        foreach (HttpResponseMessage answer in new[] { first, second })
        {
            Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
            Dictionary<string, double> times = answer.Headers.GetValues("Server-Timing").Single().Split(", ").ToDictionary(
                time => time.Split(';')[0], time => double.Parse(time.Split('=')[1], CultureInfo.InvariantCulture));
            Assert.InRange(times["wait"], 0.0, 0.5 * times["draw"]);
        }
    }

    private Task UntilMostWaitAsync() => Within.Seconds(60.0, "most requests to wait", () =>
    {
        string metrics = server.Client.GetStringAsync("/metrics").GetAwaiter().GetResult();
        string waiting = metrics.Split('\n').Single(line => line.StartsWith("msisf_waiting ", StringComparison.Ordinal));
        return int.Parse(waiting.Split(' ')[1], CultureInfo.InvariantCulture) > MostWaiting / 2;
    });

    private static async Task<HttpResponseMessage> AskAsync(
        HttpClient client, string? name, int width, int height, CancellationToken cancellation)
    {
        using HttpRequestMessage request = new(HttpMethod.Post, "/v1/render")
        {
            Content = new StringContent(
                FormattableString.Invariant(
                    $$"""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": {{width}}, "height": {{height}}}"""),
                Encoding.UTF8, "application/json"),
        };
        if (name is not null)
        {
            request.Headers.Add("X-Msisf-Client", name);
        }

        return await client.SendAsync(request, cancellation);
    }
}
