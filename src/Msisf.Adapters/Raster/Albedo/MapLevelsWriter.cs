using System.Runtime.InteropServices;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// Decodes a map and writes it with its coarser levels. The map is read from north to south; memory holds a few rows of each level.
/// </summary>
internal sealed class MapLevelsWriter
{
    /// <summary>Code of the value 0 of a map of bytes; bytes are whole codes, and means keep 8 more bits.</summary>
    private const double CodesPerByteStep = 256.0;

    private const int MaxCode = ushort.MaxValue;
    private const int RowsAtOnce = 16;

    private readonly Stream _stream;
    private readonly MapLevelsHeader _header;
    private readonly long[] _offsets;
    private readonly MapReducer?[] _reducers;
    private readonly ushort[] _codes;

    private MapLevelsWriter(Stream stream, MapLevelsHeader header, MapExtent extent)
    {
        _stream = stream;
        _header = header;
        IReadOnlyList<(int Width, int Height)> levels = header.Levels;
        _offsets = [.. Enumerable.Range(0, levels.Count).Select(header.OffsetOf)];
        _codes = new ushort[header.Width];
        _reducers = [.. levels.Select((size, level) => level + 1 < levels.Count
            ? new MapReducer(size.Width, size.Height, extent, (row, values) => WriteRow(level + 1, row, values))
            : null)];
    }

    /// <summary>Writes the levels.</summary>
    /// <param name="files">The map's files, for their checksums.</param>
    /// <param name="stream">An empty file.</param>
    /// <exception cref="BadInputException">The map is damaged, without any data, or too large.</exception>
    public static MapLevelsHeader Write(MapFiles files, MapSource source, Stream stream)
    {
        if ((long)source.Width * source.Height > int.MaxValue)
        {
            throw new BadInputException(
                $"{files.Place}: {source.Width} x {source.Height} pixels; maps of up to {int.MaxValue} pixels are read. "
                    + $"Give a coarser one.");
        }

        (long bytes, long written) = files.State();
        byte[][] hashes = files.Hashes();
        (double offset, double step) = source.IsBytes
            ? (-1.0 / CodesPerByteStep, 1.0 / CodesPerByteStep)
            : CodesOfReals(files.Place, source);
        MapLevelsHeader header = new(bytes, written, hashes, source.Width, source.Height, offset, step, source.Extent);
        stream.SetLength(header.FileBytes);
        MapExtent extent = source.Extent ?? MapExtent.WholeMoon;
        MapLevelsWriter writer = new(stream, header, extent);
        ForEachRow(source, (row, values) => writer.WriteRow(0, row, values));
        stream.Position = 0;
        stream.Write(header.ToBytes());
        return header;
    }

    private static void ForEachRow(MapSource source, RowAction action)
    {
        float[] rows = new float[RowsAtOnce * source.Width];
        for (int first = 0; first < source.Height; first += RowsAtOnce)
        {
            int count = Math.Min(RowsAtOnce, source.Height - first);
            source.Read(first, count, rows);
            for (int row = 0; row < count; row++)
            {
                action(first + row, rows.AsSpan(row * source.Width, source.Width));
            }
        }
    }

    /// <summary>The value of code 0 and of a step: the map's least value is code 1, its greatest the last code.</summary>
    private static (double Offset, double Step) CodesOfReals(string path, MapSource source)
    {
        float least = float.PositiveInfinity;
        float greatest = float.NegativeInfinity;
        ForEachRow(source, (_, values) =>
        {
            foreach (float value in values)
            {
                if (float.IsFinite(value))
                {
                    least = Math.Min(least, value);
                    greatest = Math.Max(greatest, value);
                }
            }
        });
        if (least > greatest)
        {
            throw new BadInputException($"{path}: the map has no data at all. Give another one.");
        }

        double step = greatest > least ? ((double)greatest - least) / (MaxCode - 1) : 1.0;
        return (least - step, step);
    }

    private void WriteRow(int level, int row, ReadOnlySpan<float> values)
    {
        Span<ushort> codes = _codes.AsSpan(0, values.Length);
        double perStep = 1.0 / _header.Step;
        double offset = 0.5 - (_header.Offset * perStep);
        for (int i = 0; i < codes.Length; i++)
        {
            double value = values[i];
            codes[i] = double.IsFinite(value) ? (ushort)Math.Clamp((value * perStep) + offset, 1.0, MaxCode) : (ushort)0;
        }

        _stream.Position = _offsets[level] + ((long)row * values.Length * sizeof(ushort));
        _stream.Write(MemoryMarshal.AsBytes(codes));
        _reducers[level]?.Add(row, values);
    }

    private delegate void RowAction(int row, ReadOnlySpan<float> values);
}
