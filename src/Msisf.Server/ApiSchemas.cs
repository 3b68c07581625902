using System.Text.Json.Nodes;
using Microsoft.OpenApi;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Server;

/// <summary>Schemas of what requests and answers hold; those of a frame's options are made from the table of options.</summary>
internal static class ApiSchemas
{
    public const string Frame = "Frame";
    public const string SurfacePoint = "SurfacePoint";
    public const string ImagePoint = "ImagePoint";

    /// <summary>The schemas that types of the program have.</summary>
    public static IReadOnlyList<(string Name, Type Type)> Types { get; } =
        [(SurfacePoint, typeof(SurfaceReading)), (ImagePoint, typeof(PixelReading)), (nameof(Problem), typeof(ProblemText))];

    public static OpenApiSchema OfFrame()
    {
        Dictionary<string, IOpenApiSchema> properties = new()
        {
            [JsonOptions.ModelKey] = new OpenApiSchema
            {
                AnyOf = [Of(JsonSchemaType.String), ListOf(Of(JsonSchemaType.String))],
                Description = "Elevation model, a name of /v1/models; a list of names draws them as one surface",
            },
            [RequestStates.Key] = new OpenApiSchema
            {
                AnyOf = [Of(JsonSchemaType.String), ListOf(ListOf(Of(JsonSchemaType.Number)))],
                Description = "The camera's trajectory: [MJD, rx, ry, rz, vx, vy, vz] for each state, m and m/s along orbit-frame, or the "
                    + "name of an OEM of /v1/folders; time says when the image is taken",
            },
            [ScanOptions.Trajectory.Key] = new OpenApiSchema
            {
                Type = JsonSchemaType.Array,
                Items = ListOf(Of(JsonSchemaType.Number)),
                Description = "States that are samples of the camera's motion, [MJD, rx, ry, rz, qx, qy, qz, q0] each, with six more for "
                    + "its velocities; the image is taken between them, at time, or from the first one on",
            },
            [ScanOptions.Jitter.Key] = new OpenApiSchema
            {
                Type = JsonSchemaType.Array,
                Items = ListOf(new OpenApiSchema { AnyOf = [Of(JsonSchemaType.Number), Of(JsonSchemaType.String)] }),
                Description = "Small turns of the camera: [seconds, roll, pitch, yaw] (microradians) or [axis, Hz, microradians, rad] each",
            },
        };
        foreach (OptionSpec option in CommandTable.OptionsOfRequest)
        {
            properties[option.Key] = OfOption(option);
        }

        return Closed(properties);
    }

    /// <summary>A frame, or one with the cameras that it is drawn with.</summary>
    public static OpenApiSchema OfRender(OpenApiDocument document)
    {
        OpenApiSchema camera = new()
        {
            Type = JsonSchemaType.Object,
            Description = "A camera: its name, how it is mounted (quaternion, offset), and options of its images",
            Properties = StreamCamera.Keys.ToDictionary<string, string, IOpenApiSchema>(
                key => key, key => key == StreamCamera.NameKey ? Of(JsonSchemaType.String) : ListOf(Of(JsonSchemaType.Number))),
        };
        OpenApiSchema rig = Closed(new()
        {
            [StreamCamera.FrameKey] = new OpenApiSchemaReference(Frame, document),
            [StreamCamera.ListKey] = ListOf(camera),
        });
        rig.Required = new HashSet<string> { StreamCamera.FrameKey, StreamCamera.ListKey };
        return new OpenApiSchema { OneOf = [new OpenApiSchemaReference(Frame, document), rig] };
    }

    /// <param name="name">Name of the list.</param>
    /// <param name="description">What a point is.</param>
    /// <param name="most">The largest count of its numbers.</param>
    public static Func<OpenApiDocument, IOpenApiSchema> OfPoints(string name, string description, int most = 2) => document =>
    {
        OpenApiSchema point = ListOf(Of(JsonSchemaType.Number));
        (point.MinItems, point.MaxItems) = (2, most);
        OpenApiSchema points = ListOf(point);
        points.Description = description;
        OpenApiSchema schema = Closed(new() { ["frame"] = new OpenApiSchemaReference(Frame, document), [name] = points });
        schema.Required = new HashSet<string> { "frame", name };
        return schema;
    };

    /// <param name="name">Name of the list.</param>
    /// <param name="item">Name of the schema of its elements.</param>
    /// <param name="isNullable">Whether an element may be null.</param>
    public static Func<OpenApiDocument, IOpenApiSchema> OfList(string name, string item, bool isNullable) => document =>
    {
        OpenApiSchemaReference reference = new(item, document);
        return new OpenApiSchema
        {
            Type = JsonSchemaType.Object,
            Required = new HashSet<string> { name },
            Properties = new Dictionary<string, IOpenApiSchema>
            {
                [name] = ListOf(isNullable ? new OpenApiSchema { AnyOf = [reference, Of(JsonSchemaType.Null)] } : reference),
            },
        };
    };

    public static OpenApiSchema Of(JsonSchemaType type) => new() { Type = type };

    private static OpenApiSchema OfOption(OptionSpec option)
    {
        OpenApiSchema schema = Of(option switch
        {
            FlagSpec => JsonSchemaType.Boolean,
            TextSpec { ValueIfBare: not null } => JsonSchemaType.Boolean | JsonSchemaType.String | JsonSchemaType.Number,
            ChoiceSpec => JsonSchemaType.String,
            NumberSpec => JsonSchemaType.Number | JsonSchemaType.String,
            WholeNumberSpec => JsonSchemaType.Integer | JsonSchemaType.String,
            NumberListSpec => JsonSchemaType.Array | JsonSchemaType.String,
            _ when option == ImageOptions.Camera => JsonSchemaType.String | JsonSchemaType.Object,
            _ => JsonSchemaType.String | JsonSchemaType.Number | JsonSchemaType.Array,
        });
        schema.Description = $"{option.Help}{(option.Notes.Length > 0 ? $" ({option.Notes})" : string.Empty)}";
        schema.Enum = option is ChoiceSpec choice
            ? [.. choice.Suggestions.Select(word => JsonValue.Create(word))]
            : null;
        return schema;
    }

    private static OpenApiSchema ListOf(IOpenApiSchema items) => new() { Type = JsonSchemaType.Array, Items = items };

    private static OpenApiSchema Closed(Dictionary<string, IOpenApiSchema> properties) => new()
    {
        Type = JsonSchemaType.Object,
        AdditionalPropertiesAllowed = false,
        Properties = properties,
    };
}
