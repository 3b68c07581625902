using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The OpenAPI document says what the server does.</summary>
public sealed class OpenApiTests(RunningServer server) : IClassFixture<RunningServer>
{
    [RequiresFact(Part.Ldem4)]
    public async Task Paths_AreThose_OfTheServer()
    {
        JsonElement document = await ReadAsync();

        Assert.Equal(
            server.Server.Routes.Order(StringComparer.Ordinal),
            document.GetProperty("paths").EnumerateObject()
                .SelectMany(path => path.Value.EnumerateObject().Select(method => $"{method.Name.ToUpperInvariant()} {path.Name}"))
                .Order(StringComparer.Ordinal));
    }

    /// <summary>An option that a request may not have is another error than a wrong value.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task OptionsOfAFrame_AreKnown_ToTheServer()
    {
        JsonElement options = (await ReadAsync()).GetProperty("components").GetProperty("schemas").GetProperty("Frame").GetProperty("properties");

        foreach (string name in options.EnumerateObject().Select(option => option.Name))
        {
            using HttpResponseMessage answer = await server.PostAsync("/v1/render", $"{{\"{name}\": null}}");
            string text = await answer.Content.ReadAsStringAsync();
            Assert.Equal(System.Net.HttpStatusCode.BadRequest, answer.StatusCode);
            Assert.DoesNotContain("is no option", text, StringComparison.Ordinal);
            Assert.DoesNotContain("can't stand", text, StringComparison.Ordinal);
        }
    }

    /// <summary>Each content type that the document promises is what the server sends.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task ContentTypesOfRender_AreSent()
    {
        JsonElement render = (await ReadAsync()).GetProperty("paths").GetProperty("/v1/render").GetProperty("post");
        string[] types = [.. render.GetProperty("responses").GetProperty("200").GetProperty("content").EnumerateObject().Select(type => type.Name)];

        Assert.Equal(7, types.Length);
        foreach (string type in types.Where(type => type != AnswerForm.Fits)) // needs layers and CFITSIO: another test
        {
            using HttpResponseMessage answer = await server.PostAsync("/v1/render", $"{{{RunningServer.SmallFrame}}}", type);
            Assert.Equal(type, answer.Content.Headers.ContentType!.MediaType);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public async Task References_LeadToSchemas()
    {
        JsonElement document = await ReadAsync();
        string[] schemas = [.. document.GetProperty("components").GetProperty("schemas").EnumerateObject().Select(schema => schema.Name)];
        string[] references = [.. References(document)];

        Assert.NotEmpty(references);
        Assert.All(references, reference => Assert.Contains(reference.Split('/')[^1], schemas));
    }

    private static IEnumerable<string> References(JsonElement json) => json.ValueKind switch
    {
        JsonValueKind.Object => json.EnumerateObject().SelectMany(
            member => member.Name == "$ref" ? [member.Value.GetString()!] : References(member.Value)),
        JsonValueKind.Array => json.EnumerateArray().SelectMany(References),
        _ => [],
    };

    private async Task<JsonElement> ReadAsync() =>
        await RunningServer.JsonOf(await server.Client.GetAsync("/openapi.json"));
}
