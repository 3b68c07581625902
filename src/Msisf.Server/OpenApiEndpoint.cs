using Microsoft.AspNetCore.OpenApi;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.OpenApi;

namespace Msisf.Server;

/// <summary>GET /openapi.json: the server's description for programs (OpenAPI 3.1), made of its routes when first asked for.</summary>
internal sealed class OpenApiEndpoint
{
    private const string DocumentName = "msis";

    private static readonly string[] ProblemStatuses =
        ["400", "401", "403", "404", "406", "408", "413", "414", "415", "422", "429", "431", "503"];

    private string? _document;

    /// <summary>Adds what the endpoint needs.</summary>
    /// <param name="services">The server's services.</param>
    public static void AddServices(IServiceCollection services, string version)
    {
        services.ConfigureHttpJsonOptions(json =>
        {
            json.SerializerOptions.PropertyNamingPolicy = JsonBody.Names.PropertyNamingPolicy;
            json.SerializerOptions.NumberHandling = JsonBody.Names.NumberHandling;
            json.SerializerOptions.TypeInfoResolverChain.Insert(0, AnswerTypes.Default);
        });
        services.AddOpenApi(DocumentName, options =>
        {
            options.AddOperationTransformer((operation, context, _) =>
            {
                Describe(operation, context);
                return Task.CompletedTask;
            });
            options.AddDocumentTransformer(async (document, context, cancellation) =>
            {
                document.Info = new OpenApiInfo
                {
                    Title = "MSISF server",
                    Version = version,
                    Description = "Draws exact synthetic images of the Moon. docs/server.md says more.",
                };
                (document.Servers, document.Tags) = (null, null);
                document.AddComponent(ApiSchemas.Frame, ApiSchemas.OfFrame());
                foreach ((string name, Type type) in ApiSchemas.Types)
                {
                    document.AddComponent(name, await context.GetOrCreateSchemaAsync(type, null, cancellation).ConfigureAwait(false));
                }
            });
        });
    }

    public async Task AnswerAsync(HttpContext context)
    {
        if (_document is null)
        {
            OpenApiDocument document = await context.RequestServices.GetRequiredKeyedService<IOpenApiDocumentProvider>(DocumentName)
                .GetOpenApiDocumentAsync(context.RequestAborted).ConfigureAwait(false);
            using StringWriter text = new(CultureInfo.InvariantCulture);
            document.SerializeAsV31(new OpenApiJsonWriter(text, new OpenApiJsonWriterSettings { Terse = true }));
            _document = text.ToString();
        }

        context.Response.ContentType = AnswerForm.Json;
        await context.Response.WriteAsync(_document).ConfigureAwait(false);
    }

    private static void Describe(OpenApiOperation operation, OpenApiOperationTransformerContext context)
    {
        RouteText text = context.Description.ActionDescriptor.EndpointMetadata.OfType<RouteText>().Single();
        string path = context.Description.RelativePath!;
        operation.Tags?.Clear();
        operation.Summary = text.Summary;
        operation.OperationId = context.Description.HttpMethod!.ToLowerInvariant() + string.Concat(
            path.Split(['/', '{', '}', '.'], StringSplitOptions.RemoveEmptyEntries).Where(word => word != "v1")
                .Select(word => char.ToUpperInvariant(word[0]) + word[1..]));
        operation.Parameters =
        [
            .. path.Split('/').Where(word => word.StartsWith('{')).Select(word => Parameter(word.Trim('{', '}'), ParameterLocation.Path)),
            .. text.Query.Select(name => Parameter(name, ParameterLocation.Query)),
        ];
        operation.RequestBody = text.Body is { } body
            ? new OpenApiRequestBody { Required = true, Content = Content([AnswerForm.Json], body(context.Document!)) }
            : null;
        operation.Responses = new OpenApiResponses
        {
            ["200"] = new OpenApiResponse
            {
                Description = "The answer.",
                Content = Content(text.ContentTypes, text.Answer?.Invoke(context.Document!)),
            },
        };
        foreach (string status in ProblemStatuses)
        {
            operation.Responses[status] = new OpenApiResponse
            {
                Description = "What is wrong, in the words of the command line.",
                Content = Content([Problem.ContentType], new OpenApiSchemaReference(nameof(Problem), context.Document)),
            };
        }
    }

    private static OpenApiParameter Parameter(string name, ParameterLocation place) => new()
    {
        Name = name,
        In = place,
        Required = place == ParameterLocation.Path,
        Schema = ApiSchemas.Of(name == "number" ? JsonSchemaType.Integer : JsonSchemaType.String),
    };

    private static Dictionary<string, OpenApiMediaType> Content(IEnumerable<string> types, IOpenApiSchema? schema) =>
        types.ToDictionary(type => type, _ => new OpenApiMediaType { Schema = schema });
}

/// <summary>What the server's description for programs says about a route.</summary>
/// <param name="Summary">What it does: one sentence.</param>
/// <param name="ContentTypes">Content types of its answers.</param>
internal sealed record RouteText(string Summary, params IReadOnlyList<string> ContentTypes)
{
    public IReadOnlyList<string> Query { get; init; } = [];

    /// <summary>Makes the schema of a request's body; null for a request without one.</summary>
    public Func<OpenApiDocument, IOpenApiSchema>? Body { get; init; }

    /// <summary>Makes the schema of an answer; null for any.</summary>
    public Func<OpenApiDocument, IOpenApiSchema>? Answer { get; init; }
}
