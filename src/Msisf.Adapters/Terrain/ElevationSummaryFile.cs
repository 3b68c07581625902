using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Terrain;

/// <summary>
/// Stores a model's <see cref="ElevationSummary"/> beside it, since making one reads the whole model. A file that is damaged or of another
/// model counts as missing. Layout: a magic number, the source's fingerprint (32 bytes), SHA-256 of the rest, then little-endian 32-bit
/// floats.
/// </summary>
public static class ElevationSummaryFile
{
    private const int HashBytes = 32;

    private static ReadOnlySpan<byte> Magic => "MSISFSM1"u8;

    /// <summary>Reads the summary, or makes and stores it.</summary>
    /// <param name="path">The file beside the model.</param>
    /// <param name="source">What the model is now.</param>
    /// <param name="grid">The model.</param>
    /// <returns>The summary, and why it could not be stored; null if it was, or need not be.</returns>
    public static (ElevationSummary Summary, string? Warning) LoadOrBuild(string path, SummarySource source, IElevationGrid grid)
    {
        if (TryLoad(path, source) is ElevationSummary stored)
        {
            return (stored, null);
        }

        ElevationSummary summary = ElevationSummary.Build(grid);
        try
        {
            AtomicFile.Write(path, stream => Write(stream, source, summary));
        }
        catch (ExternalPartException exception)
        {
            return (summary, $"{exception.Message} The model's summary is made anew in each run.");
        }

        return (summary, null);
    }

    /// <summary>Writes a summary.</summary>
    public static void Write(Stream stream, SummarySource source, ElevationSummary summary)
    {
        float[] values = summary.ToValues();
        byte[] payload = new byte[sizeof(float) * values.Length];
        for (int index = 0; index < values.Length; index++)
        {
            BinaryPrimitives.WriteSingleLittleEndian(payload.AsSpan(sizeof(float) * index), values[index]);
        }

        stream.Write(Magic);
        stream.Write(source.Fingerprint());
        stream.Write(SHA256.HashData(payload));
        stream.Write(payload);
    }

    /// <summary>Reads a summary.</summary>
    /// <returns>Null if the content is not a whole summary of this very source.</returns>
    public static ElevationSummary? Read(ReadOnlySpan<byte> content, SummarySource source)
    {
        int head = Magic.Length + (2 * HashBytes);
        if (content.Length < head || content.Length % sizeof(float) != head % sizeof(float) || !content.StartsWith(Magic)
            || !content.Slice(Magic.Length, HashBytes).SequenceEqual(source.Fingerprint())
            || !content.Slice(Magic.Length + HashBytes, HashBytes).SequenceEqual(SHA256.HashData(content[head..])))
        {
            return null;
        }

        ReadOnlySpan<byte> payload = content[head..];
        float[] values = new float[payload.Length / sizeof(float)];
        for (int index = 0; index < values.Length; index++)
        {
            values[index] = BinaryPrimitives.ReadSingleLittleEndian(payload[(sizeof(float) * index)..]);
        }

        return ElevationSummary.FromValues(source.PixelsPerDegree, values);
    }

    private static ElevationSummary? TryLoad(string path, SummarySource source)
    {
        try
        {
            return File.Exists(path) ? Read(File.ReadAllBytes(path), source) : null;
        }
        catch (Exception exception) when (exception.IsFileError() || exception is BadInputException)
        {
            return null; // an unreadable file is as good as none: the summary is made again
        }
    }
}
