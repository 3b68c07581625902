using System.Buffers;

namespace Msisf.Adapters.Manifest;

/// <summary>Reads a manifest, and later the lines that others have appended to it. Not for several threads.</summary>
public sealed class ManifestReader : IDisposable
{
    private const int ChunkBytes = 1 << 20;

    /// <summary>Bytes. A line has some hundred; a longer one is not a line of a manifest, and is not kept in memory.</summary>
    private const int LongestLine = 1 << 20;

    private readonly string _path;
    private FileStream? _stream;
    private byte[] _rest = [];
    private bool _isInOverlongLine;

    /// <summary>Names the manifest.</summary>
    /// <param name="manifest">It may be missing.</param>
    /// <param name="onlyNew">Leave out what is in it now.</param>
    /// <exception cref="ExternalPartException">It can't be read.</exception>
    public ManifestReader(ManifestFile manifest, bool onlyNew = false)
    {
        _path = manifest.FilePath;
        if (onlyNew && TryOpen())
        {
            _stream!.Seek(0, SeekOrigin.End);
        }
    }

    /// <summary>What was read so far.</summary>
    public ManifestContent Content { get; } = new();

    /// <summary>Reads what was appended since the last call. An incomplete last line waits for the next call.</summary>
    /// <returns>Whether there was more.</returns>
    /// <exception cref="ExternalPartException">The file can't be read.</exception>
    public bool Refresh() => FileErrors.ToExternalPart($"{_path}: can't be read", () =>
    {
        if (!TryOpen() || _stream!.Position >= _stream.Length)
        {
            return false;
        }

        byte[] buffer = ArrayPool<byte>.Shared.Rent(ChunkBytes);
        for (int read = _stream.Read(buffer); read > 0; read = _stream.Read(buffer))
        {
            Take((byte[])[.. _rest, .. buffer.AsSpan(0, read)]);
        }

        ArrayPool<byte>.Shared.Return(buffer);
        return true;
    });

    /// <summary>Closes the file.</summary>
    public void Dispose() => _stream?.Dispose();

    private bool TryOpen()
    {
        if (_stream is null && File.Exists(_path))
        {
            // A manifest that is replaced meanwhile is read to its end: what is missed then is made twice, the same bytes.
            _stream = new FileStream(_path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        }

        return _stream is not null;
    }

    private void Take(ReadOnlyMemory<byte> bytes)
    {
        for (int end = bytes.Span.IndexOf((byte)'\n'); end >= 0; end = bytes.Span.IndexOf((byte)'\n'))
        {
            Content.Add(_isInOverlongLine ? null : ManifestLine.TryRead(bytes[..end]));
            _isInOverlongLine = false;
            bytes = bytes[(end + 1)..];
        }

        _isInOverlongLine |= bytes.Length > LongestLine;
        _rest = _isInOverlongLine ? [] : bytes.ToArray();
    }
}
