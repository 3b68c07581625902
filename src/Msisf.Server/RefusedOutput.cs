using System.Buffers;
using System.IO.Pipelines;
using System.Text;
using Microsoft.AspNetCore.WebUtilities;

namespace Msisf.Server;

/// <summary>
/// What a connection sends. A request that the web server itself refuses (no HTTP, a head that is too long or too slow) it answers without
/// a body, and no part of this program is asked; here a problem takes the place of that answer.
/// </summary>
/// <param name="output">Sends.</param>
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
