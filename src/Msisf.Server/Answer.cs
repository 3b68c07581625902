using System.Globalization;
using System.Text;
using Microsoft.AspNetCore.Http;

namespace Msisf.Server;

/// <summary>What a request for a frame is answered with: one part, or several in one multipart answer.</summary>
/// <param name="pool">Memory of the parts.</param>
/// <param name="room">bytes: left free before the content of a part.</param>
internal sealed class Answer(StreamPool pool, int room = 0) : IDisposable
{
    /// <summary>Separates the parts; too long to be in one by chance.</summary>
    private const string Boundary = "msisf-part-5e1f2c7a9d3b4860";

    private readonly List<AnswerPart> _parts = [];

    /// <summary>The parts.</summary>
    public IReadOnlyList<AnswerPart> Parts => _parts;

    /// <summary>Times of the work, for the header Server-Timing: name and ms.</summary>
    public List<(string Name, double Milliseconds)> Times { get; } = [];

    /// <summary>Adds a part.</summary>
    /// <param name="name">Name of a file with it.</param>
    /// <param name="contentType">Its content type.</param>
    /// <param name="write">Writes it.</param>
    /// <param name="headers">Further headers.</param>
    public void Add(string name, string contentType, Action<MemoryStream> write, params (string Name, string Value)[] headers)
    {
        MemoryStream content = pool.Take();
        _parts.Add(new AnswerPart(name, contentType, content, headers));
        content.SetLength(room);
        content.Position = room;
        write(content);
    }

    /// <summary>Sends the answer.</summary>
    /// <param name="response">Receives it.</param>
    /// <param name="isMultipart">Whether the parts are separated by boundaries; if not, there is one.</param>
    /// <param name="cancellation">Stops sending.</param>
    public async Task SendAsync(HttpResponse response, bool isMultipart, CancellationToken cancellation)
    {
        response.Headers["Server-Timing"] = string.Join(", ", Times.Select(
            time => string.Create(CultureInfo.InvariantCulture, $"{time.Name};dur={time.Milliseconds:F3}")));
        if (isMultipart)
        {
            response.ContentType = $"multipart/mixed; boundary={Boundary}";
            foreach (AnswerPart part in _parts)
            {
                await response.Body.WriteAsync(Encoding.ASCII.GetBytes(HeadOf(part)), cancellation).ConfigureAwait(false);
                await response.Body.WriteAsync(part.Bytes, cancellation).ConfigureAwait(false);
            }

            await response.Body.WriteAsync(Encoding.ASCII.GetBytes($"\r\n--{Boundary}--\r\n"), cancellation).ConfigureAwait(false);
            return;
        }

        AnswerPart only = _parts[0];
        response.ContentType = only.ContentType;
        response.ContentLength = only.Bytes.Length;
        foreach ((string name, string value) in only.Headers)
        {
            response.Headers[name] = value;
        }

        await response.Body.WriteAsync(only.Bytes, cancellation).ConfigureAwait(false);
    }

    /// <summary>Gives the memory back.</summary>
    public void Dispose()
    {
        foreach (AnswerPart part in _parts)
        {
            pool.GiveBack(part.Content);
        }

        _parts.Clear();
    }

    private static string HeadOf(AnswerPart part)
    {
        StringBuilder head = new();
        head.Append(CultureInfo.InvariantCulture, $"\r\n--{Boundary}\r\nContent-Type: {part.ContentType}\r\n");
        head.Append(CultureInfo.InvariantCulture, $"Content-Disposition: attachment; filename=\"{part.Name}\"\r\n");
        head.Append(CultureInfo.InvariantCulture, $"Content-Length: {part.Bytes.Length}\r\n");
        foreach ((string name, string value) in part.Headers)
        {
            head.Append(CultureInfo.InvariantCulture, $"{name}: {value}\r\n");
        }

        return head.Append("\r\n").ToString();
    }
}
