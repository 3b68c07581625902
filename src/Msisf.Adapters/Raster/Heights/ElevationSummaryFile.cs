using Msisf.Adapters.IO;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Stores what is known of a model's <see cref="ElevationSummary"/> beside it, because reading it again takes long. A file that is damaged
/// or of another model counts as missing. Layout: a magic number, the source's fingerprint (32 bytes), SHA-256 of the rest, then
/// little-endian 32-bit floats; blocks that are not known are 0.
/// </summary>
public static class ElevationSummaryFile
{
    /// <summary>Samples that are read in some 0.3 s; storing and loading the file takes a third of that.</summary>
    private const long MinSamplesRead = 1L << 26;

    /// <summary>The summary on demand of a model, with what is stored of it.</summary>
    /// <param name="path">The file beside the model.</param>
    /// <param name="source">What the model is now.</param>
    public static ElevationSummary Open(string path, SummarySource source, IGlobalGrid grid)
    {
        try
        {
            return (File.Exists(path) ? Read(File.ReadAllBytes(path), source, grid) : null) ?? ElevationSummary.OnDemand(grid);
        }
        catch (Exception exception) when (exception.IsFileError() || exception is BadInputException)
        {
            return ElevationSummary.OnDemand(grid); // an unreadable file is as good as none
        }
    }

    /// <summary>Stores a summary, if so much of the model was read for it that the next run should not read it again.</summary>
    /// <param name="path">The file beside the model.</param>
    /// <param name="source">What the model was when it was opened.</param>
    /// <param name="minSamplesRead">How much is so much.</param>
    /// <returns>Why it could not be stored; null if it was, or need not be.</returns>
    public static string? StoreIfWorthwhile(
        string path, SummarySource source, ElevationSummary summary, long minSamplesRead = MinSamplesRead)
    {
        try
        {
            if (summary.SamplesRead >= minSamplesRead)
            {
                AtomicFile.Write(path, stream => Write(stream, source, summary));
            }

            return null;
        }
        catch (ExternalPartException exception)
        {
            return $"{exception.Message} The next run reads the same parts of the model again.";
        }
    }

    /// <summary>Writes a summary.</summary>
    public static void Write(Stream stream, SummarySource source, ElevationSummary summary) =>
        HashedContent.Write(stream, HeadOf(source), writer => Array.ForEach(summary.ToValues(), writer.Write));

    /// <summary>Reads a summary.</summary>
    /// <returns>Null if the content is not a whole summary of this very source.</returns>
    public static ElevationSummary? Read(ReadOnlySpan<byte> content, SummarySource source, IGlobalGrid grid)
    {
        using BinaryReader? reader = HashedContent.TryRead(content, HeadOf(source));
        if (reader is null || reader.BaseStream.Length % sizeof(float) != 0)
        {
            return null;
        }

        float[] values = new float[reader.BaseStream.Length / sizeof(float)];
        for (int index = 0; index < values.Length; index++)
        {
            values[index] = reader.ReadSingle();
        }

        return ElevationSummary.OnDemand(grid, values);
    }

    private static byte[] HeadOf(SummarySource source) => [.. "MSISFSM1"u8, .. source.Fingerprint()];
}
