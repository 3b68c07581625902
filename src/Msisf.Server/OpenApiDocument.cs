using System.Text.Json;
using System.Text.Json.Nodes;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Server;

/// <summary>GET /openapi.json: the server's description for programs (OpenAPI 3.1); a frame's options come from the option table.</summary>
internal static class OpenApiDocument
{
    private static readonly string[] ProblemStatuses =
        ["400", "401", "403", "404", "406", "408", "413", "414", "415", "422", "429", "431", "503"];

    /// <summary>The document.</summary>
    /// <param name="version">Version of the program.</param>
    public static byte[] Write(string version)
    {
        JsonObject document = new()
        {
            ["openapi"] = "3.1.0",
            ["info"] = new JsonObject
            {
                ["title"] = "MSISF server",
                ["version"] = version,
                ["description"] = "Draws exact synthetic images of the Moon. docs/server.md says more.",
            },
            ["paths"] = new JsonObject
            {
                ["/v1/render"] = Post("Draws a frame.", Reference("Frame"), AnswerForm.All),
                ["/v1/pixels"] = Post(
                    "Says what points of an image show.",
                    FrameWith("pixels", "[x, y]: pixels from 1 for the middle of the first one, x right, y down", 2, 2),
                    [AnswerForm.Json],
                    Member("points", ListOf(Nullable("SurfacePoint")))),
                ["/v1/points"] = Post(
                    "Says where places of the Moon are seen in an image.",
                    FrameWith(
                        "points", "[latitude, longitude] or [latitude, longitude, height]: degrees, m over the sphere of 1737400 m", 2, 3),
                    [AnswerForm.Json],
                    Member("pixels", ListOf(Reference("ImagePoint")))),
                ["/v1/sun"] = Get(
                    "Says where the Sun is at a time, and where it stands in the sky of a place.", AnswerForm.Json,
                    ["utc", "mjd", "latitude", "longitude", "ephemeris", "aberration"]),
                ["/v1/models"] = Get("Lists the names that requests may use.", AnswerForm.Json, []),
                ["/v1/catalogues/{name}"] = Get("Lists the craters of a catalogue, the largest first.", AnswerForm.Json, []),
                ["/v1/folders"] = Get("Lists the output folders and batch files of --folders.", AnswerForm.Json, []),
                ["/v1/folders/{name}"] = Get("Lists the frames of one.", AnswerForm.Json, []),
                ["/v1/folders/{name}/frames/{number}/{kind}"] = Get(
                    "Sends a file of a frame: image, annotated or meta.", AnswerForm.Png, []),
                ["/v1/stream"] = Get("A WebSocket on which states go in and images come out.", AnswerForm.Json, []),
                ["/healthz"] = Get("Says that the server is there.", "text/plain", []),
                ["/metrics"] = Get("Counts of what the server did, as Prometheus reads them.", "text/plain", []),
                ["/openapi.json"] = Get("This document.", AnswerForm.Json, []),
            },
            ["components"] = new JsonObject
            {
                ["schemas"] = new JsonObject
                {
                    ["Frame"] = Frame(),
                    ["SurfacePoint"] = Properties(
                        ["latitude", "longitude", "height", "position", "distance", "incidence", "emission", "phase",
                         "illumination_direction", "lit", "lit_fraction", "pixel_scale", "slope", "facet"]),
                    ["ImagePoint"] = Properties(["x", "y", "visible", "hidden_by", "lit"]),
                    ["Problem"] = Properties(["type", "title", "status", "detail", "options"]),
                },
            },
        };
        foreach ((string path, JsonNode? methods) in document["paths"]!.AsObject())
        {
            foreach ((string method, JsonNode? operation) in methods!.AsObject())
            {
                Identify(operation!.AsObject(), method, path);
            }
        }

        return JsonSerializer.SerializeToUtf8Bytes(document);
    }

    /// <summary>Names an operation after its path, "getFoldersName", and declares the parameters that stand in it.</summary>
    private static void Identify(JsonObject operation, string method, string path)
    {
        string[] words = path.Split(['/', '{', '}', '.'], StringSplitOptions.RemoveEmptyEntries);
        operation["operationId"] = method + string.Concat(
            words.Where(word => word != "v1").Select(word => char.ToUpperInvariant(word[0]) + word[1..]));
        string[] names = [.. path.Split('/').Where(word => word.StartsWith('{')).Select(word => word.Trim('{', '}'))];
        if (names.Length > 0)
        {
            operation["parameters"] = new JsonArray([.. names.Select(name => (JsonNode)new JsonObject
            {
                ["name"] = name,
                ["in"] = "path",
                ["required"] = true,
                ["schema"] = new JsonObject { ["type"] = name == "number" ? "integer" : "string" },
            })]);
        }
    }

    /// <summary>The options of a frame, from the option table.</summary>
    private static JsonObject Frame()
    {
        JsonObject properties = new()
        {
            ["model"] = new JsonObject
            {
                ["anyOf"] = new JsonArray(
                    new JsonObject { ["type"] = "string" }, ListOf(new JsonObject { ["type"] = "string" })),
                ["description"] = "Elevation model, a name of /v1/models; a list of names draws them as one surface",
            },
        };
        foreach (OptionSpec option in CommandTable.OptionsOfRequest)
        {
            properties[option.Key] = Option(option);
        }

        return new JsonObject { ["type"] = "object", ["additionalProperties"] = false, ["properties"] = properties };
    }

    private static JsonObject Option(OptionSpec option)
    {
        string notes = option.Notes.Length > 0 ? $" ({option.Notes})" : string.Empty;
        JsonObject schema = new() { ["description"] = $"{option.Help}{notes}" };
        JsonNode type = option switch
        {
            FlagSpec => "boolean",
            NumberSpec => Types("number", "string"),
            WholeNumberSpec => Types("integer", "string"),
            NumberListSpec => Types("array", "string"),
            _ when option == ImageOptions.Camera => Types("string", "object"),
            _ => Types("string", "number", "array"),
        };
        schema["type"] = type;
        if (option is ChoiceSpec choice)
        {
            schema["enum"] = new JsonArray([.. choice.Suggestions.Select(word => (JsonNode)word)]);
            schema["type"] = "string";
        }

        return schema;
    }

    private static JsonArray Types(params string[] names) => new([.. names.Select(name => (JsonNode)name)]);

    private static JsonObject Get(string summary, string contentType, string[] parameters)
    {
        JsonObject get = new() { ["summary"] = summary, ["responses"] = Responses([contentType], schema: null) };
        if (parameters.Length > 0)
        {
            get["parameters"] = new JsonArray([.. parameters.Select(name => (JsonNode)new JsonObject
            {
                ["name"] = name, ["in"] = "query", ["schema"] = new JsonObject { ["type"] = "string" },
            })]);
        }

        return new JsonObject { ["get"] = get };
    }

    private static JsonObject Post(string summary, JsonObject body, IReadOnlyList<string> contentTypes, JsonObject? answer = null) => new()
    {
        ["post"] = new JsonObject
        {
            ["summary"] = summary,
            ["requestBody"] = new JsonObject
            {
                ["required"] = true,
                ["content"] = new JsonObject { [AnswerForm.Json] = new JsonObject { ["schema"] = body } },
            },
            ["responses"] = Responses(contentTypes, answer),
        },
    };

    private static JsonObject Responses(IReadOnlyList<string> contentTypes, JsonObject? schema)
    {
        JsonObject content = [];
        foreach (string type in contentTypes)
        {
            content[type] = schema is null ? new JsonObject() : new JsonObject { ["schema"] = schema.DeepClone() };
        }

        JsonObject responses = new() { ["200"] = new JsonObject { ["description"] = "The answer.", ["content"] = content } };
        foreach (string status in ProblemStatuses)
        {
            responses[status] = new JsonObject
            {
                ["description"] = "What is wrong, in the words of the command line.",
                ["content"] = new JsonObject { [Problem.ContentType] = new JsonObject { ["schema"] = Reference("Problem") } },
            };
        }

        return responses;
    }

    private static JsonObject FrameWith(string name, string description, int least, int most) => new()
    {
        ["type"] = "object",
        ["additionalProperties"] = false,
        ["required"] = Types("frame", name),
        ["properties"] = new JsonObject
        {
            ["frame"] = Reference("Frame"),
            [name] = new JsonObject
            {
                ["type"] = "array",
                ["description"] = description,
                ["items"] = new JsonObject
                {
                    ["type"] = "array",
                    ["items"] = new JsonObject { ["type"] = "number" },
                    ["minItems"] = least,
                    ["maxItems"] = most,
                },
            },
        },
    };

    private static JsonObject Properties(string[] names)
    {
        JsonObject properties = [];
        foreach (string name in names)
        {
            properties[name] = new JsonObject();
        }

        return new JsonObject { ["type"] = "object", ["required"] = Types(names), ["properties"] = properties };
    }

    private static JsonObject Member(string name, JsonObject schema) => new()
    {
        ["type"] = "object",
        ["required"] = Types(name),
        ["properties"] = new JsonObject { [name] = schema },
    };

    private static JsonObject ListOf(JsonObject items) => new() { ["type"] = "array", ["items"] = items };

    private static JsonObject Nullable(string name) => new()
    {
        ["anyOf"] = new JsonArray(Reference(name), new JsonObject { ["type"] = "null" }),
    };

    private static JsonObject Reference(string name) => new() { ["$ref"] = $"#/components/schemas/{name}" };
}
