using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map at half its resolution, for maps that have more pixels than are read. Rows are read from north to south.</summary>
internal sealed class HalvedMapSource(MapSource source) : MapSource
{
    private readonly Queue<float[]> _finished = new();
    private readonly float[] _row = new float[source.Width];
    private MapReducer? _reducer;
    private int _next;

    /// <inheritdoc/>
    public override int Width { get; } = AlbedoMapLevel.Below(source.Width, source.Height).Width;

    /// <inheritdoc/>
    public override int Height { get; } = AlbedoMapLevel.Below(source.Width, source.Height).Height;

    /// <inheritdoc/>
    public override MapExtent? Extent => source.Extent;

    /// <inheritdoc/>
    public override bool IsBytes => source.IsBytes;

    /// <summary>Reads whole rows: from the first on, or those that follow the last ones.</summary>
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
