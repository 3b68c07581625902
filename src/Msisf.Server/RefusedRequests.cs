using System.Buffers;
using System.Diagnostics;
using System.IO.Pipelines;
using System.Text;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.WebUtilities;

namespace Msisf.Server;

/// <summary>Answers what the web server refuses before a part of this program sees it.</summary>
/// <param name="metrics">Counts the answers.</param>
internal sealed class RefusedRequests(ServerMetrics metrics) : IObserver<KeyValuePair<string, object?>>
{
    private const string Refused = "Microsoft.AspNetCore.Server.Kestrel.BadRequest";

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

/// <summary>
/// What a connection sends. A request that the web server itself refuses (no HTTP, a head that is too long or too slow) it answers without
/// a body, and no part of this program is asked; here a problem takes the place of that answer.
/// </summary>
internal sealed class RefusedOutput(PipeWriter output) : PipeWriter
{
    private byte[]? _answer;
    private byte[] _unsent = [];
    private bool _isSent;

    public override bool CanGetUnflushedBytes => output.CanGetUnflushedBytes;

    public override long UnflushedBytes => output.UnflushedBytes;

    /// <summary>Puts a problem in the place of all that would be sent from now on.</summary>
    public void Refuse(Problem problem)
    {
        byte[] body = problem.ToJson();
        string head = Invariant(
            $"HTTP/1.1 {problem.Status} {ReasonPhrases.GetReasonPhrase(problem.Status)}\r\nContent-Type: {Problem.ContentType}\r\n"
                + $"Content-Length: {body.Length}\r\nCache-Control: no-cache\r\nX-Content-Type-Options: nosniff\r\n"
                + $"Connection: close\r\n\r\n");
        _answer = [.. Encoding.ASCII.GetBytes(head), .. body];
    }

    public override Memory<byte> GetMemory(int sizeHint = 0) => _answer is null ? output.GetMemory(sizeHint) : Unsent(sizeHint);

    public override Span<byte> GetSpan(int sizeHint = 0) => _answer is null ? output.GetSpan(sizeHint) : Unsent(sizeHint);

    public override void Advance(int bytes)
    {
        if (_answer is null)
        {
            output.Advance(bytes);
        }
    }

    public override ValueTask<FlushResult> FlushAsync(CancellationToken cancellationToken = default)
    {
        if (_answer is not null && !_isSent)
        {
            _isSent = true;
            output.Write(_answer);
        }

        return output.FlushAsync(cancellationToken);
    }

    public override void CancelPendingFlush() => output.CancelPendingFlush();

    public override void Complete(Exception? exception = null) => output.Complete(exception);

    private byte[] Unsent(int sizeHint)
    {
        if (_unsent.Length < Math.Max(sizeHint, Environment.SystemPageSize))
        {
            _unsent = new byte[Math.Max(sizeHint, Environment.SystemPageSize)];
        }

        return _unsent;
    }
}
