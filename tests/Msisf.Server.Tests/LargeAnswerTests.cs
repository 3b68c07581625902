using System.Net;
using System.Security.Cryptography;
using System.Text;
using Microsoft.AspNetCore.Http;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Answers that are too long for memory, or for the server.</summary>
public sealed class LargeAnswerTests(RunningServer server) : IClassFixture<RunningServer>
{
    /// <summary>1024 x 1024 px of 8 doubles each: 67 MB.</summary>
    private const string Layers = """
        "fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 1024, "height": 1024,
        "layers": ["position", "normal", "depth", "range"], "layers-format": "npy"
        """;

    private const string Depth = """
        "fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 1024, "height": 1024, "layers": "depth", "layers-format": "npy"
        """;

    /// <summary>Sent as it is made, the answer holds what an answer from memory holds.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task LayersSentAsTheyAreMade_AreThoseOfAShortAnswer()
    {
        byte[] depth = await server.RenderAsync(Depth, "application/x-npy");
        byte[] parts = await server.RenderAsync(Layers, "multipart/mixed, application/octet-stream, application/json");

        Assert.True(parts.Length > AnswerPlan.LargestInMemory);
        string[] names = ["image.raw", "depth.npy", "range.npy", "position.npy", "normal.npy", "layers.json", "json"];
        int place = 0;
        foreach (string name in names)
        {
            (string head, ReadOnlyMemory<byte> content) = PartOf(parts, ref place);
            Assert.Contains($"filename=\"{name}\"", head, StringComparison.Ordinal);
            Assert.True(name != "depth.npy" || content.Span.SequenceEqual(depth), "the depth differs");
        }

        Assert.Equal("\r\n--msisf-part-5e1f2c7a9d3b4860--\r\n", Encoding.ASCII.GetString(parts.AsSpan(place)));
    }

    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public async Task FitsSentAsItIsMade_IsThatOfItsPart()
    {
        if (!TestLength.IsLong)
        {
            return;
        }

        string options = Layers.Replace("npy", "fits", StringComparison.Ordinal);
        byte[] fits = await server.RenderAsync(options, "application/fits");
        byte[] parts = await server.RenderAsync(options, "multipart/mixed, application/octet-stream, application/json");

        int place = 0;
        PartOf(parts, ref place);
        Assert.Equal(SHA256.HashData(fits), SHA256.HashData(PartOf(parts, ref place).Content.Span));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"layers\": [\"position\", \"normal\"]", "multipart/mixed", HttpStatusCode.RequestEntityTooLarge)]
    [InlineData("\"layers\": [\"position\", \"normal\"]", "image/png", HttpStatusCode.OK)]
    [InlineData("\"layers\": \"depth\"", "multipart/mixed", HttpStatusCode.OK)]
    public async Task AnswerAboveTheLimit_SaysHowToAskForLess(string layers, string accept, HttpStatusCode status)
    {
        using RunningServer small = await RunningServer.StartAsync((ServeOptions.MaxMegabytes, "1"));
        using HttpResponseMessage answer = await small.PostAsync(
            "/v1/render", $"{{{RunningServer.SmallFrame.Replace("64", "512", StringComparison.Ordinal)}, {layers}}}", accept);
        string text = await answer.Content.ReadAsStringAsync();

        Assert.True(answer.StatusCode == status, text);
        Assert.True(
            status == HttpStatusCode.OK || text.Contains(
                "the answer has 1 MB, more than the server's --max-megabytes of 1. Ask for fewer 'layers', 'layers-precision' single or a "
                    + "smaller 'width' and 'height'.",
                StringComparison.Ordinal),
            text);
        await small.DisposeAsync();
    }

    /// <summary>The same parts, sent at the end or as they come, are the same bytes.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task StreamedAnswer_HasTheBytesOfAnAnswerFromMemory(bool isMultipart)
    {
        (byte[] expected, IHeaderDictionary headers) = await SentAsync(isMultipart, (pool, _) => new Answer(pool));
        (byte[] sent, IHeaderDictionary sentHeaders) = await SentAsync(
            isMultipart, (pool, response) => new StreamedAnswer(pool, response, isMultipart));

        Assert.Equal(expected, sent);
        Assert.Equal(headers.ContentType, sentHeaders.ContentType);
        Assert.Equal(expected.Length, headers.ContentLength);
        Assert.Equal(isMultipart ? null : 300_000, sentHeaders.ContentLength);
    }

    private static async Task<(byte[] Bytes, IHeaderDictionary Headers)> SentAsync(
        bool isMultipart, Func<StreamPool, HttpResponse, Answer> make)
    {
        byte[] content = new byte[300_000];
        new Random(20261123).NextBytes(content);
        DefaultHttpContext context = new();
        using MemoryStream body = new();
        context.Response.Body = new ResponseStream(body, TimeSpan.FromMinutes(1));
        using Answer answer = make(new StreamPool(), context.Response);
        answer.AddLarge("depth.npy", AnswerForm.Npy, content.Length, stream => stream.Write(content), ("X-Msisf-Planes", "1"));
        if (isMultipart)
        {
            answer.AddLarge("fits", AnswerForm.Fits, null, stream => stream.Write(content));
            answer.Add("json", AnswerForm.Json, stream => stream.Write("{}"u8));
        }

        await answer.SendAsync(context.Response, isMultipart, default);
        return (body.ToArray(), context.Response.Headers);
    }

    /// <summary>The part at a place of a multipart answer, which then is that of the next.</summary>
    private static (string Head, ReadOnlyMemory<byte> Content) PartOf(byte[] parts, ref int place)
    {
        int end = place + parts.AsSpan(place).IndexOf("\r\n\r\n"u8) + 4;
        string head = Encoding.ASCII.GetString(parts.AsSpan(place, end - place));
        string length = head.Split("Content-Length: ")[1].Split("\r\n")[0];
        place = end + int.Parse(length, System.Globalization.CultureInfo.InvariantCulture);
        return (head, parts.AsMemory(end, place - end));
    }
}
