using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.IO.Compression;
using System.Text;

namespace Msisf.Adapters.Ccsds;

/// <summary>
/// Reads CCSDS files: orbit ephemeris messages (OEM 1.0, 2.0, 3.0) and attitude ephemeris messages (AEM 1.0, 2.0), as lines (KVN) or XML,
/// also compressed by gzip. A state takes 64 bytes of memory, an attitude 48, and 80 with rates.
/// </summary>
/// <param name="scale">Turns the files' times into TDB.</param>
/// <param name="moonMeFromMoonPa">Reads the constant rotation from the Moon's principal axes.</param>
/// <param name="note">Receives a sentence for what was put right.</param>
public sealed class CcsdsFile(TimeScale scale, Func<RotationMatrix> moonMeFromMoonPa, Action<string>? note = null)
{
    /// <summary>Reads files by the kernels of a run.</summary>
    /// <param name="kernels">The engine with its kernels.</param>
    /// <param name="note">Receives a sentence for what was put right.</param>
    public CcsdsFile(OpenedEphemeris kernels, Action<string> note)
        : this(
            kernels.Engine.TimeScale,
            () => FrameKernel.ReadBodyFixedFrame(kernels.Catalogue.Pool, CelestialBody.Moon.Frame).FrameFromOrientation, note)
    {
    }

    /// <summary>Whether a file begins as an OEM does.</summary>
    /// <param name="head">Its first characters; the name of the format is below comments of XML.</param>
    public static bool IsOem(string head) => head.Contains("CCSDS_OEM_VERS", StringComparison.Ordinal);

    /// <summary>Reads the states of an OEM.</summary>
    /// <param name="stream">The file; read once from start to end.</param>
    /// <param name="fileName">Its name, for messages.</param>
    /// <exception cref="BadInputException">The first thing that is wrong, by file and line.</exception>
    public IReadOnlyList<TrajectoryBlock> ReadOem(Stream stream, string fileName)
    {
        OemMessage message = new(new CcsdsPlace(fileName), scale, moonMeFromMoonPa);
        Read(stream, message);
        if (message.Warning is { } warning)
        {
            note?.Invoke(warning);
        }

        return RequireBlocks(message.Blocks, message.Place);
    }

    /// <summary>Reads the attitudes of an AEM.</summary>
    /// <param name="stream">The file; read once from start to end.</param>
    /// <param name="fileName">Its name, for messages.</param>
    /// <param name="isRounded">Whether quaternions may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">The first thing that is wrong, by file and line.</exception>
    public IReadOnlyList<AttitudeBlock> ReadAem(Stream stream, string fileName, bool isRounded)
    {
        AemMessage message = new(new CcsdsPlace(fileName), scale, moonMeFromMoonPa, isRounded);
        Read(stream, message);
        return RequireBlocks(message.Blocks, message.Place);
    }

    private void Read(Stream stream, CcsdsMessage message)
    {
        try
        {
            using StreamReader reader = new(Decompressed(stream), Encoding.UTF8);
            if (reader.Peek() == '<')
            {
                new CcsdsXmlReader(message).Read(reader);
            }
            else
            {
                new CcsdsKvnReader(message).Read(reader);
            }
        }
        catch (Exception exception) when (exception is InvalidDataException or IOException)
        {
            throw message.Place.Error($"can't be read on: {exception.Message}", exception);
        }

        foreach (string text in message.Place.Notes)
        {
            note?.Invoke(text);
        }
    }

    /// <summary>The text of a file, which may be compressed by gzip.</summary>
    internal static Stream Decompressed(Stream stream)
    {
        byte[] start = new byte[2];
        int count = stream.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        Stream whole = new PrefixedStream(start.AsMemory(0, count), stream);
        return start is [0x1F, 0x8B] ? new GZipStream(whole, CompressionMode.Decompress) : whole;
    }

    private static IReadOnlyList<T> RequireBlocks<T>(IReadOnlyList<T> blocks, CcsdsPlace place) => blocks.Count > 0
        ? blocks
        : throw new NothingToRenderException($"{place.FileName}: no block of it has a line of numbers.");
}

/// <summary>A stream whose first bytes were read already: it gives them again, then the rest.</summary>
/// <param name="rest">The stream behind them.</param>
internal sealed class PrefixedStream(ReadOnlyMemory<byte> start, Stream rest) : Stream
{
    private ReadOnlyMemory<byte> _start = start;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

    public override int Read(Span<byte> buffer)
    {
        if (_start.IsEmpty)
        {
            return rest.Read(buffer);
        }

        int count = Math.Min(buffer.Length, _start.Length);
        _start.Span[..count].CopyTo(buffer);
        _start = _start[count..];
        return count;
    }

    public override void Flush()
    {
    }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
}
