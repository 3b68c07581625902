using System.Text.Json;
using System.Text.RegularExpressions;
using Microsoft.OpenApi;
using Microsoft.OpenApi.Reader;
using Msisf.App.Settings;
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
            Assert.DoesNotContain("is not an option", text, StringComparison.Ordinal);
            Assert.DoesNotContain("can't be in a request", text, StringComparison.Ordinal);
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

    /// <summary>Programs that are generated from the document read answers by these schemas.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("/v1/pixels", "\"pixels\": [[32, 24]]", "points", "SurfacePoint")]
    [InlineData("/v1/points", "\"points\": [[0, 0], [0, 180]]", "pixels", "ImagePoint")]
    public async Task Answers_HaveTheMembersOfTheirSchemas(string path, string list, string name, string schemaName)
    {
        JsonElement schema = (await ReadAsync()).GetProperty("components").GetProperty("schemas").GetProperty(schemaName);
        using HttpResponseMessage answer = await server.PostAsync(path, $"{{\"frame\": {{{RunningServer.SmallFrame}}}, {list}}}");
        JsonElement points = (await RunningServer.JsonOf(answer)).GetProperty(name);

        Assert.NotEqual(0, points.GetArrayLength());
        Assert.All(points.EnumerateArray(), point => RequireSchema(schema, point));
    }

    /// <summary>An option that a JSON number gives is a number in the document; one of the table's is not forgotten.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task OptionsOfAFrame_AreThoseOfTheTable_WithTheirKinds()
    {
        JsonElement options = (await ReadAsync()).GetProperty("components").GetProperty("schemas").GetProperty("Frame").GetProperty(
            "properties");

        Assert.Equal(
            CommandTable.OptionsOfRequest.Select(option => option.Key)
                .Prepend("jitter").Prepend("trajectory").Prepend("states").Prepend("model"),
            options.EnumerateObject().Select(option => option.Name));
        Assert.Contains("number", TypesOf(options.GetProperty("fov")));
        Assert.Contains("integer", TypesOf(options.GetProperty("width")));
        Assert.Contains("array", TypesOf(options.GetProperty("fixed-state")));
        Assert.Equal(["boolean"], TypesOf(options.GetProperty("ignore-sun")));
        Assert.Equal(
            ["none", "lt", "lt+s"],
            options.GetProperty("aberration").GetProperty("enum").EnumerateArray().Select(word => word.GetString()));
        Assert.Equal(
            "Horizontal field of view (above 0, below 180; default: 40)",
            options.GetProperty("fov").GetProperty("description").GetString());
    }

    private static void RequireSchema(JsonElement schema, JsonElement value)
    {
        Assert.Contains(
            value.ValueKind switch
            {
                JsonValueKind.Object => "object",
                JsonValueKind.Array => "array",
                JsonValueKind.String => "string",
                JsonValueKind.Null => "null",
                JsonValueKind.Number => TypesOf(schema).Contains("integer") ? "integer" : "number",
                _ => "boolean",
            },
            TypesOf(schema));
        if (value.ValueKind == JsonValueKind.Object)
        {
            string[] names = [.. value.EnumerateObject().Select(member => member.Name)];
            Assert.Empty(schema.GetProperty("required").EnumerateArray().Select(name => name.GetString()!).Except(names));
            Assert.All(
                value.EnumerateObject(),
                member => RequireSchema(schema.GetProperty("properties").GetProperty(member.Name), member.Value));
        }
    }

    private static IEnumerable<string> TypesOf(JsonElement schema) =>
        schema.GetProperty("type") is { ValueKind: JsonValueKind.Array } several
            ? several.EnumerateArray().Select(type => type.GetString()!)
            : [schema.GetProperty("type").GetString()!];

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
