using System.Text.Json;
using System.Text.RegularExpressions;
using Microsoft.OpenApi;
using Microsoft.OpenApi.Reader;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The OpenAPI document says what the server does.</summary>
public sealed class OpenApiTests(RunningServer server) : IClassFixture<RunningServer>
{
    /// <summary>Read by a library that follows the specification: paths, and the parameters in them, are those of the routes.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Document_IsValid_AndHasThePathsAndParametersOfTheServer()
    {
        ReadResult read = Microsoft.OpenApi.OpenApiDocument.Parse(await server.Client.GetStringAsync("/openapi.json"), "json");
        (string Route, OpenApiOperation Operation)[] operations = [.. read.Document!.Paths.SelectMany(
            path => path.Value.Operations!.Select(operation => ($"{operation.Key} {path.Key}", operation.Value)))];

        Assert.Empty(read.Diagnostic!.Errors);
        Assert.Empty(read.Diagnostic.Warnings);
        Assert.Equal(OpenApiSpecVersion.OpenApi3_1, read.Diagnostic.SpecificationVersion);
        Assert.Equal(
            server.Server.Routes.Order(StringComparer.Ordinal),
            operations.Select(operation => operation.Route).Order(StringComparer.Ordinal));
        Assert.All(operations, operation => Assert.Equal(
            ParametersOf(operation.Route).Order(),
            (operation.Operation.Parameters ?? []).Where(parameter => parameter is { In: ParameterLocation.Path, Required: true })
                .Select(parameter => parameter.Name!).Order()));
        string[] ids = [.. operations.Select(operation => operation.Operation.OperationId!)];
        Assert.All(ids, id => Assert.Matches("^[a-z][A-Za-z]+$", id));
        Assert.Distinct(ids);
    }

    /// <summary>What a program generated from the document asks of /v1/sun is known there.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task QueryOfSun_IsKnown_ToTheServer()
    {
        ReadResult read = Microsoft.OpenApi.OpenApiDocument.Parse(await server.Client.GetStringAsync("/openapi.json"), "json");
        string[] names = [.. read.Document!.Paths["/v1/sun"].Operations![HttpMethod.Get].Parameters!.Select(parameter => parameter.Name!)];

        using HttpResponseMessage answer = await server.Client.GetAsync($"/v1/sun?{string.Join('&', names.Select(name => $"{name}=x"))}");

        Assert.NotEmpty(names);
        Assert.DoesNotContain("is not known here", await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }

    /// <summary>An option that a request may not have is another error than a wrong value.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task OptionsOfAFrame_AreKnown_ToTheServer()
    {
        JsonElement schemas = (await ReadAsync()).GetProperty("components").GetProperty("schemas");
        JsonElement options = schemas.GetProperty("Frame").GetProperty("properties");

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
        JsonElement content = render.GetProperty("responses").GetProperty("200").GetProperty("content");
        string[] types = [.. content.EnumerateObject().Select(type => type.Name)];

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

    private static IEnumerable<string> ParametersOf(string route) =>
        Regex.Matches(route, @"\{(\w+)\}").Select(match => match.Groups[1].Value);

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
