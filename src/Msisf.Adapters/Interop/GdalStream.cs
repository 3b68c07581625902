using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>A virtual file of GDAL's, e.g. one on another computer or in an archive, to be read. Not safe for several threads.</summary>
internal sealed unsafe class GdalStream : Stream
{
    private const int FromEnd = 2;

    private readonly GdalNative _gdal;
    private nint _file;
    private long _position;

    /// <summary>Opens a file.</summary>
    /// <param name="path">As GDAL names it, e.g. "/vsicurl/https://...".</param>
    /// <exception cref="IOException">There is none, or it can't be reached.</exception>
    public GdalStream(string path)
    {
        _gdal = GdalLibrary.AnyLoaded() ?? throw new IOException($"{path} needs GDAL's library.");
        fixed (byte* name = Encoding.UTF8.GetBytes(path + '\0'), mode = "rb\0"u8)
        {
            _file = _gdal.VSIFOpenL(name, mode);
        }

        if (_file == 0)
        {
            throw new IOException($"{path} can't be opened.");
        }

        _ = _gdal.VSIFSeekL(_file, 0, FromEnd);
        Length = (long)_gdal.VSIFTellL(_file);
    }

    public override bool CanRead => true;

    public override bool CanSeek => true;

    public override bool CanWrite => false;

    public override long Length { get; }

    public override long Position
    {
        get => _position;
        set => _position = value;
    }

    public override int Read(byte[] buffer, int offset, int count)
    {
        fixed (byte* start = buffer.AsSpan(offset, count))
        {
            _ = _gdal.VSIFSeekL(_file, (ulong)_position, 0);
            int read = (int)_gdal.VSIFReadL(start, 1, (nuint)count, _file);
            if (read == 0 && count > 0 && _position < Length)
            {
                throw new IOException(Invariant(
                    $"the remote file broke off after {_position} of {Length} bytes. Try again, or get the whole file and name it here"));
            }

            _position += read;
            return read;
        }
    }

    public override long Seek(long offset, SeekOrigin origin) => _position = origin switch
    {
        SeekOrigin.Begin => offset,
        SeekOrigin.Current => _position + offset,
        _ => Length + offset,
    };

    public override void Flush()
    {
    }

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        if (Interlocked.Exchange(ref _file, 0) is not 0 and nint file)
        {
            _ = _gdal.VSIFCloseL(file);
        }

        base.Dispose(disposing);
    }
}
