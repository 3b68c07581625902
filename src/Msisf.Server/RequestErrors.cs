using Microsoft.AspNetCore.Routing;
using Microsoft.AspNetCore.WebUtilities;
using Msisf.App.Host;

namespace Msisf.Server;

/// <summary>Turns what goes wrong with a request into a problem; all exceptions of requests are caught here.</summary>
internal static class RequestErrors
{
    /// <summary>Handles a request.</summary>
    /// <param name="next">Answers it.</param>
    /// <param name="guard">Refuses requests of other sites.</param>
    /// <param name="metrics">Counts the answer.</param>
    /// <param name="log">Receives bugs.</param>
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
