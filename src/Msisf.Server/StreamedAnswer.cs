using System.Text;

namespace Msisf.Server;

/// <summary>An answer that is too long for memory: each part is sent as soon as it is made, by the thread that makes it.</summary>
/// <param name="pool">Memory of the parts that are made as a whole.</param>
/// <param name="response">Receives the answer.</param>
/// <param name="isMultipart">Whether the parts are separated by boundaries; if not, there is one.</param>
internal sealed class StreamedAnswer(StreamPool pool, HttpResponse response, bool isMultipart) : Answer(pool)
{
    private static readonly MemoryStream Nothing = new(0);

    private readonly ResponseStream _body = (ResponseStream)response.Body;

    public override void Add(string name, string contentType, MemoryStream content, params (string Name, string Value)[] headers)
    {
        base.Add(name, contentType, content, headers);
        AnswerPart part = Parts[^1];
        Begin(part with { Length = part.Bytes.Length });
        _body.Write(part.Bytes.Span);
        Dispose();
    }

    public override void AddLarge(
        string name, string contentType, long? length, Action<Stream> write, params (string Name, string Value)[] headers)
    {
        if (length is null && isMultipart)
        {
            AddFromFile(name, contentType, write, headers);
            return;
        }

        Begin(new AnswerPart(Prefix + name, contentType, Nothing, headers) { Length = length });
        write(_body);
    }

    public override async Task SendAsync(HttpResponse response, bool isMultipart, CancellationToken cancellation)
    {
        if (isMultipart)
        {
            await response.Body.WriteAsync(End, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>Each part of several says its length first; of this one it is known when it is made.</summary>
    private void AddFromFile(string name, string contentType, Action<Stream> write, (string Name, string Value)[] headers)
    {
        using FileStream file = new(
            Path.GetTempFileName(), FileMode.Create, FileAccess.ReadWrite, FileShare.None, bufferSize: 1 << 16, FileOptions.DeleteOnClose);
        write(file);
        Begin(new AnswerPart(Prefix + name, contentType, Nothing, headers) { Length = file.Length });
        file.Position = 0;
        file.CopyTo(_body);
    }

    private void Begin(AnswerPart part)
    {
        if (!response.HasStarted)
        {
            _body.Stop = Stop;
            SetHeaders(response, isMultipart, part);
        }

        if (isMultipart)
        {
            _body.Write(Encoding.ASCII.GetBytes(HeadOf(part)));
        }
    }
}
