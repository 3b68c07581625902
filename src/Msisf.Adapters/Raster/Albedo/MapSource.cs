using System.Buffers.Binary;
using System.Runtime.InteropServices;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>An equirectangular map in a file, row by row. Not safe for several threads.</summary>
internal abstract class MapSource(int width, int height, MapExtent? extent, bool isBytes) : IDisposable
{
    /// <summary>Pixels from west to east.</summary>
    public int Width => width;

    /// <summary>Pixels from north to south.</summary>
    public int Height => height;

    /// <summary>What the map shows; null if the file does not say.</summary>
    public MapExtent? Extent => extent;

    /// <summary>The stored values are whole numbers from 0 to 255.</summary>
    public bool IsBytes => isBytes;

    /// <summary>Reads whole rows.</summary>
    /// <param name="first">The first row, from 0.</param>
    /// <param name="values">Receives the stored values, row by row; NaN where there is no data.</param>
    /// <exception cref="Core.Errors.BadInputException">The file is damaged.</exception>
    public abstract void Read(int first, int count, Span<float> values);

    /// <summary>Closes the file.</summary>
    public abstract void Dispose();
}

/// <summary>
/// A map at half its resolution, for maps that have more pixels than are read. Whole rows are read from the first on, or those that follow
/// the last ones.
/// </summary>
internal sealed class HalvedMapSource(MapSource source) : MapSource(
    AlbedoMapLevel.Below(source.Width, source.Height).Width, AlbedoMapLevel.Below(source.Width, source.Height).Height, source.Extent,
    source.IsBytes)
{
    private readonly Queue<float[]> _finished = new();
    private readonly float[] _row = new float[source.Width];
    private MapReducer? _reducer;
    private int _next;

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        if (first == 0 || _reducer is null)
        {
            _finished.Clear();
            _next = 0;
            _reducer = new MapReducer(
                source.Width, source.Height, Extent ?? MapExtent.WholeMoon, (_, row) => _finished.Enqueue(row.ToArray()));
        }

        for (int row = 0; row < count; row++)
        {
            while (_finished.Count == 0)
            {
                source.Read(_next, 1, _row);
                _reducer.Add(_next++, _row);
            }

            _finished.Dequeue().CopyTo(values[(row * Width)..]);
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => source.Dispose();
}

/// <summary>A map in several files, row by row across all of them. Where no tile lies there is no data.</summary>
internal sealed class TiledMapSource : MapSource
{
    private readonly MapTileLayout _layout;
    private readonly List<PdsMapSource> _sources = [];
    private float[] _rows = [];

    /// <summary>Opens the images of all tiles.</summary>
    /// <exception cref="Core.Errors.BadInputException">An image is missing, unreadable, or shorter than its label says.</exception>
    public TiledMapSource(MapTileLayout layout)
        : base(layout.Width, layout.Height, layout.Extent, isBytes: layout.Tiles[0].Label.SampleType.Bytes == 1)
    {
        _layout = layout;
        try
        {
            _sources.AddRange(layout.Tiles.Select(tile => new PdsMapSource(tile.Label)));
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        values[..(count * Width)].Fill(float.NaN);
        foreach ((PlacedMapTile tile, PdsMapSource source) in _layout.Tiles.Zip(_sources))
        {
            int start = Math.Max(first, tile.Row);
            int rows = Math.Min(first + count, tile.Row + source.Height) - start;
            if (rows <= 0)
            {
                continue;
            }

            Array.Resize(ref _rows, Math.Max(_rows.Length, rows * source.Width));
            source.Read(start - tile.Row, rows, _rows);
            for (int row = 0; row < rows; row++)
            {
                _rows.AsSpan(row * source.Width, source.Width).CopyTo(values[(((start - first + row) * Width) + tile.Column)..]);
            }
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _sources.ForEach(source => source.Dispose());
}

/// <summary>A map in a PDS3 image: whole numbers of 8 or 16 bits, or real numbers of 32.</summary>
internal sealed class PdsMapSource : MapSource
{
    /// <summary>Real numbers below this are the special values of USGS ISIS: no data.</summary>
    private const float LeastReal = -1e30f;

    private readonly PdsMapLabel _label;
    private readonly FileStream _stream;
    private byte[] _bytes = [];

    /// <summary>Opens the image of a label.</summary>
    /// <exception cref="BadInputException">The image is missing, unreadable, or shorter than the label says.</exception>
    public PdsMapSource(PdsMapLabel label)
        : base(label.LineSamples, label.Lines, label.Extent, isBytes: label.SampleType.Bytes == 1)
    {
        _label = label;
        _stream = FileErrors.ToBadInput(
            $"{label.ImagePath}: can't be read", () => new FileStream(label.ImagePath, FileMode.Open, FileAccess.Read, FileShare.Read));
        long needed = label.ImageOffset + ((long)label.Lines * label.LineSamples * label.SampleType.Bytes);
        long found = _stream.Length;
        if (found < needed)
        {
            _stream.Dispose();
            throw new BadInputException(
                $"{label.ImagePath}: {found} bytes, {needed} expected ({label.Lines} lines of {label.LineSamples} samples by "
                    + $"{label.LabelPath}). Get the file again.");
        }
    }

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        int sampleBytes = _label.SampleType.Bytes;
        int length = count * Width * sampleBytes;
        Array.Resize(ref _bytes, Math.Max(_bytes.Length, length));
        FileErrors.ToBadInput($"{_label.ImagePath}: can't be read", () =>
        {
            _stream.Position = _label.ImageOffset + ((long)first * Width * sampleBytes);
            _stream.ReadExactly(_bytes, 0, length);
            return true;
        });
        values = values[..(count * Width)];
        Decode(_bytes.AsSpan(0, length), values);
        if (_label.MissingConstant is double missing)
        {
            values.Replace((float)missing, float.NaN);
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _stream.Dispose();

    private void Decode(Span<byte> bytes, Span<float> values)
    {
        Span<ushort> numbers = MemoryMarshal.Cast<byte, ushort>(bytes);
        Span<uint> words = MemoryMarshal.Cast<byte, uint>(bytes);
        bool isReversed = _label.SampleType.IsBigEndian == BitConverter.IsLittleEndian;
        switch (_label.SampleType.Bytes)
        {
            case 1:
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = bytes[i];
                }

                break;
            case 2:
                if (isReversed)
                {
                    BinaryPrimitives.ReverseEndianness(numbers, numbers);
                }

                bool isSigned = _label.SampleType.Type == PixelType.Signed16;
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = isSigned ? (short)numbers[i] : numbers[i];
                }

                break;
            default:
                if (isReversed)
                {
                    BinaryPrimitives.ReverseEndianness(words, words);
                }

                for (int i = 0; i < values.Length; i++)
                {
                    float value = BitConverter.UInt32BitsToSingle(words[i]);
                    values[i] = value > LeastReal ? value : float.NaN;
                }

                break;
        }
    }
}
