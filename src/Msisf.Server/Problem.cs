using System.Text.Json;
using System.Text.RegularExpressions;
using Microsoft.AspNetCore.Routing;
using Microsoft.AspNetCore.WebUtilities;
using Msisf.App.Host;

namespace Msisf.Server;

/// <summary>What went wrong with a request, as RFC 9457 has it: the words are those of the command line.</summary>
/// <param name="Status">HTTP status.</param>
/// <param name="Detail">What is wrong, where, and what to do.</param>
/// <param name="Options">Options that it is about, e.g. "--fov".</param>
internal sealed partial record Problem(int Status, string Detail, IReadOnlyList<string> Options)
{
    /// <summary>Characters of a request that a problem repeats at most.</summary>
    public const int LongestQuote = 200;

    /// <summary>Characters of a problem; more than the longest list of names in a message takes.</summary>
    private const int LongestDetail = 700;

    public const string ContentType = "application/problem+json";

    /// <summary>The problem of an exception; null if it is a bug of the server.</summary>
    public static Problem? Of(Exception exception) => exception switch
    {
        RefusedException refused => new Problem(refused.Status, refused.Message, []),
        SpiceException spice => new Problem(StatusCodes.Status422UnprocessableEntity, spice.Message, spice.Options),
        ExternalPartException part => new Problem(StatusCodes.Status503ServiceUnavailable, part.Message, part.Options),
        MsisfException wrong => new Problem(StatusCodes.Status400BadRequest, wrong.Message, wrong.Options),
        JsonException json => new Problem(StatusCodes.Status400BadRequest, $"the request is not JSON: {json.Message}", []),
        BadHttpRequestException bad => new Problem(bad.StatusCode, bad.Message, []),
        _ => null,
    };

    public async Task WriteAsync(HttpResponse response)
    {
        response.StatusCode = Status;
        response.ContentType = ContentType;
        if (Status == StatusCodes.Status429TooManyRequests)
        {
            response.Headers.RetryAfter = "1";
        }

        await response.Body.WriteAsync(ToJson()).ConfigureAwait(false);
    }

    public byte[] ToJson() => JsonBody.ToBytes(
        new ProblemText("about:blank", ReasonPhrases.GetReasonPhrase(Status), Status, Shortened(Detail), [.. Options.Distinct()]));

    /// <summary>
    /// The text with quotations and words cut short that are too long; of one that still is too long the middle is left out.
    /// </summary>
    public static string Shortened(string text)
    {
        string shortened = LongQuotes().Replace(
            text, match => $"{match.Value.AsSpan(0, LongestQuote - 3)}...{(match.Value[0] == '\'' ? "'" : string.Empty)}");
        return shortened.Length <= LongestDetail
            ? shortened
            : $"{shortened.AsSpan(0, LongestQuote)} ... {shortened.AsSpan(shortened.Length - LongestQuote)}";
    }

    [GeneratedRegex(@"(?<!\w)'[^']{200,}'|\S{201,}")]
    private static partial Regex LongQuotes();
}

/// <summary>A problem as clients get it.</summary>
/// <param name="Type">Always about:blank: the status says all.</param>
/// <param name="Title">The status in words.</param>
/// <param name="Status">HTTP status.</param>
/// <param name="Detail">What is wrong, where, and what to do.</param>
/// <param name="Options">Options that it is about, e.g. "--fov".</param>
internal sealed record ProblemText(string Type, string Title, int Status, string Detail, string[] Options);

/// <summary>A request that the server does not answer: too large, too many, or not what it understands.</summary>
/// <param name="status">HTTP status.</param>
/// <param name="message">What is wrong and what to do.</param>
internal sealed class RefusedException(int status, string message) : MsisfException(exitCode: 1, message, inner: null)
{
    public int Status { get; } = status;
}

/// <summary>Turns what goes wrong with a request into a problem; all exceptions of requests are caught here.</summary>
internal static class RequestErrors
{
    /// <param name="next">Answers it.</param>
    /// <param name="guard">Refuses requests of other sites.</param>
    /// <param name="metrics">Counts the answer.</param>
    public static async Task HandleAsync(HttpContext context, RequestDelegate next, RequestGuard guard, ServerMetrics metrics, ILog log)
    {
        Connection? connection = context.Features.Get<Connection>();
        connection?.RequestBegins();
        context.Response.Body = new ResponseStream(context.Response.Body, ResponseStream.LongestWrite);
        try
        {
            await AnswerAsync(context, next, guard, metrics, log).ConfigureAwait(false);
        }
        finally
        {
            connection?.RequestEnds();
        }
    }

    private static async Task AnswerAsync(HttpContext context, RequestDelegate next, RequestGuard guard, ServerMetrics metrics, ILog log)
    {
        try
        {
            guard.Check(context);
            await next(context).ConfigureAwait(false);
            if (!context.Response.HasStarted && context.Response.StatusCode is StatusCodes.Status404NotFound
                or StatusCodes.Status405MethodNotAllowed)
            {
                int status = context.Response.StatusCode;
                await new Problem(
                    status,
                    $"{context.Request.Method} {context.Request.Path}: {ReasonPhrases.GetReasonPhrase(status).ToLowerInvariant()}; "
                        + "/openapi.json lists what there is.",
                    []).WriteAsync(context.Response).ConfigureAwait(false);
            }
        }
        catch (Exception) when (context.RequestAborted.IsCancellationRequested)
        {
            metrics.Answered(PathOf(context), StatusCodes.Status499ClientClosedRequest);
            return; // nobody is there to hear of it
        }
        catch (Exception exception)
        {
            Problem problem = Problem.Of(exception) ?? Bug(exception, log);
            if (context.Response.HasStarted)
            {
                context.Abort();
                return;
            }

            await problem.WriteAsync(context.Response).ConfigureAwait(false);
        }

        metrics.Answered(PathOf(context), context.Response.StatusCode);
    }

    /// <summary>One of the server's own paths, so that clients can't make up as many as they like.</summary>
    private static string PathOf(HttpContext context) => (context.GetEndpoint() as RouteEndpoint)?.RoutePattern.RawText ?? "other";

    /// <summary>Says a bug in the log.</summary>
    /// <returns>What its client hears of it.</returns>
    internal static Problem Bug(Exception exception, ILog log)
    {
        log.Error($"a bug in msis, please report it with the request and this text: {exception.GetType().Name}: {exception.Message}");
        log.Raw(exception.StackTrace ?? string.Empty);
        return new Problem(
            StatusCodes.Status500InternalServerError,
            $"a bug in msis, please report it: {exception.GetType().Name}: {exception.Message}",
            []);
    }
}
