using System.Collections.Concurrent;
using System.Diagnostics;
using System.Text;

namespace Msisf.Server;

/// <summary>What a request for a frame is answered with: one part, or several in one multipart answer.</summary>
/// <param name="pool">Memory of the parts.</param>
/// <param name="room">bytes: left free before the content of a part.</param>
internal class Answer(StreamPool pool, int room = 0) : IDisposable
{
    /// <summary>Separates the parts; too long to be in one by chance.</summary>
    private const string Boundary = "msisf-part-5e1f2c7a9d3b4860";

    private readonly List<AnswerPart> _parts = [];

    public IReadOnlyList<AnswerPart> Parts => _parts;

    /// <summary>What the names of the next parts and times begin with: "" of an answer with one image, otherwise "camera.".</summary>
    public string Prefix { get; set; } = string.Empty;

    /// <summary>Times of the work, for the header Server-Timing: name and ms.</summary>
    public List<(string Name, double Milliseconds)> Times { get; } = [];

    /// <summary>Stops the work on the answer.</summary>
    public CancellationToken Stop { get; set; }

    /// <summary>The last bytes of a multipart answer.</summary>
    protected static ReadOnlyMemory<byte> End { get; } = Encoding.ASCII.GetBytes($"\r\n--{Boundary}--\r\n");

    /// <summary>Adds the time since a timestamp of <see cref="Stopwatch"/>.</summary>
    public void AddTime(string name, long start) => Times.Add((Prefix + name, Stopwatch.GetElapsedTime(start).TotalMilliseconds));

    /// <param name="name">Name of a file with it.</param>
    public void Add(string name, string contentType, Action<MemoryStream> write, params (string Name, string Value)[] headers) =>
        Add(name, contentType, Make(write), headers);

    /// <summary>Adds a part that <see cref="Make"/> made.</summary>
    public virtual void Add(string name, string contentType, MemoryStream content, params (string Name, string Value)[] headers) =>
        _parts.Add(new AnswerPart(Prefix + name, contentType, content, headers) { Length = content.Length });

    /// <summary>Makes the content of a part, perhaps beside other work on the answer.</summary>
    public MemoryStream Make(Action<MemoryStream> write)
    {
        MemoryStream content = pool.Take();
        content.SetLength(room);
        content.Position = room;
        write(content);
        return content;
    }

    /// <summary>Adds a part that may be too long for memory.</summary>
    /// <param name="name">Name of a file with it.</param>
    /// <param name="length">Its length in bytes; null if that is not known before it is made.</param>
    /// <param name="headers">Further headers.</param>
    public virtual void AddLarge(
        string name, string contentType, long? length, Action<Stream> write, params (string Name, string Value)[] headers) =>
        Add(name, contentType, write, headers);

    /// <summary>The first part with the contents of the others behind its own.</summary>
    public AnswerPart Joined()
    {
        MemoryStream all = _parts[0].Content;
        all.Position = all.Length; // some contents are written past the position
        foreach (AnswerPart part in _parts.Skip(1))
        {
            all.Write(part.Bytes[room..].Span);
        }

        return _parts[0];
    }

    /// <summary>Sends what has not been sent yet.</summary>
    /// <param name="isMultipart">Whether the parts are separated by boundaries; if not, there is one.</param>
    public virtual async Task SendAsync(HttpResponse response, bool isMultipart, CancellationToken cancellation)
    {
        SetHeaders(response, isMultipart, _parts[0]);
        byte[][] heads = [.. _parts.Select(part => isMultipart ? Encoding.ASCII.GetBytes(HeadOf(part)) : [])];
        if (isMultipart)
        {
            response.ContentLength = heads.Sum(head => (long)head.Length) + _parts.Sum(part => part.Content.Length) + End.Length;
        }

        foreach ((byte[] head, AnswerPart part) in heads.Zip(_parts))
        {
            await response.Body.WriteAsync(head, cancellation).ConfigureAwait(false);

            await response.Body.WriteAsync(part.Bytes, cancellation).ConfigureAwait(false);
        }

        if (isMultipart)
        {
            await response.Body.WriteAsync(End, cancellation).ConfigureAwait(false);
        }
    }

    public void Dispose()
    {
        foreach (AnswerPart part in _parts)
        {
            pool.GiveBack(part.Content);
        }

        _parts.Clear();
    }

    /// <param name="isMultipart">Whether the parts are separated by boundaries.</param>
    /// <param name="first">The first part, which is the only one without boundaries.</param>
    protected void SetHeaders(HttpResponse response, bool isMultipart, AnswerPart first)
    {
        response.Headers["Server-Timing"] = string.Join(", ", Times.Select(
            time => Invariant($"{time.Name};dur={time.Milliseconds:F3}")));
        if (isMultipart)
        {
            response.ContentType = $"multipart/mixed; boundary={Boundary}";
            return;
        }

        response.ContentType = first.ContentType;
        response.ContentLength = first.Length;
        foreach ((string name, string value) in first.Headers)
        {
            response.Headers[name] = value;
        }
    }

    /// <summary>What is before a part of several.</summary>
    protected static string HeadOf(AnswerPart part)
    {
        StringBuilder head = new();
        head.Append(CultureInfo.InvariantCulture, $"\r\n--{Boundary}\r\nContent-Type: {part.ContentType}\r\n");
        head.Append(CultureInfo.InvariantCulture, $"Content-Disposition: attachment; filename=\"{part.Name}\"\r\n");
        head.Append(CultureInfo.InvariantCulture, $"Content-Length: {part.Length}\r\n");
        foreach ((string name, string value) in part.Headers)
        {
            head.Append(CultureInfo.InvariantCulture, $"{name}: {value}\r\n");
        }

        return head.Append("\r\n").ToString();
    }
}

/// <summary>A part of an answer.</summary>
/// <param name="Name">Name of a file with it, e.g. "depth.npy".</param>
/// <param name="Content">Its bytes; empty if they are sent as they are made.</param>
/// <param name="Headers">Further headers.</param>
internal sealed record AnswerPart(string Name, string ContentType, MemoryStream Content, IReadOnlyList<(string Name, string Value)> Headers)
{
    /// <summary>bytes: its length; null if that is not known before it is sent.</summary>
    public required long? Length { get; init; }

    public ReadOnlyMemory<byte> Bytes => Content.GetBuffer().AsMemory(0, (int)Content.Length);
}

/// <summary>Memory for answers, used again: the garbage collector is slow to free what is as large as an image. Thread-safe.</summary>
internal sealed class StreamPool
{
    /// <summary>bytes: larger streams are not kept.</summary>
    private const int LargestKept = 8 << 20;

    private const int MostKept = 16;

    private readonly ConcurrentBag<MemoryStream> _idle = [];

    public MemoryStream Take()
    {
        MemoryStream stream = _idle.TryTake(out MemoryStream? idle) ? idle : new MemoryStream();
        stream.SetLength(0);
        return stream;
    }

    public void GiveBack(MemoryStream stream)
    {
        if (stream.Capacity <= LargestKept && _idle.Count < MostKept)
        {
            _idle.Add(stream);
        }
    }
}

/// <summary>An answer that is too long for memory: each part is sent as soon as it is made, by the thread that makes it.</summary>
/// <param name="pool">Memory of the parts that are made as a whole.</param>
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
