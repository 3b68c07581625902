using System.Diagnostics;
using System.IO.Pipelines;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Http.Features;

namespace Msisf.Server;

/// <summary>Answers what the web server refuses before a part of this program sees it.</summary>
/// <param name="metrics">Counts the answers.</param>
internal sealed class RefusedRequests(ServerMetrics metrics) : IObserver<KeyValuePair<string, object?>>
{
    private const string Refused = "Microsoft.AspNetCore.Server.Kestrel.BadRequest";

    /// <summary>Begins to listen.</summary>
    public IDisposable Subscribe(DiagnosticListener listener) => listener.Subscribe(this, name => name == Refused);

    /// <summary>Lets answers be replaced on a connection that speaks HTTP/1.1.</summary>
    public static Task HandleAsync(ConnectionContext context, ConnectionDelegate next)
    {
        RefusedOutput output = new(context.Transport.Output);
        context.Features.Set(output);
        context.Transport = new Pipes(context.Transport.Input, output);
        return next(context);
    }

    public void OnNext(KeyValuePair<string, object?> value)
    {
        if (value.Value is IFeatureCollection features
            && features.Get<IBadRequestExceptionFeature>()?.Error is BadHttpRequestException exception
            && features.Get<Connection>() is { IsIdle: true }
            && features.Get<IHttpRequestFeature>()?.Protocol.StartsWith("HTTP/2", StringComparison.Ordinal) != true
            && features.Get<RefusedOutput>() is { } output)
        {
            metrics.Answered("other", exception.StatusCode);
            output.Refuse(Problem.Of(exception)!);
        }
    }

    public void OnCompleted()
    {
    }

    public void OnError(Exception error)
    {
    }

    private sealed record Pipes(PipeReader Input, PipeWriter Output) : IDuplexPipe;
}
