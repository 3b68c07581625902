using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Samples of a raster that are in memory: those of a part of it.</summary>
internal sealed class RasterPart : ITerrainGrid
{
    private readonly ITerrainGrid _map;
    private readonly HeightRule _rule;
    private readonly double _sphere;
    private readonly GridWindow _part;
    private readonly Memory<float> _values;

    /// <summary>A raster of which nothing is in memory, and of which it is not known where it has data.</summary>
    /// <param name="map">The raster, of which only the size and the place count.</param>
    /// <param name="rule">What the stored values mean.</param>
    /// <param name="sphere">m: radius of the sphere over which the heights are.</param>
    public RasterPart(ITerrainGrid map, HeightRule rule, double sphere)
        : this(map, rule, sphere, default, default, hasGaps: true)
    {
    }

    private RasterPart(ITerrainGrid map, HeightRule rule, double sphere, GridWindow part, Memory<float> values, bool hasGaps) =>
        (_map, _rule, _sphere, _part, _values, MayHaveGaps) = (map, rule, sphere, part, values, hasGaps);

    /// <inheritdoc/>
    public string ProductId => _map.ProductId;

    /// <inheritdoc/>
    public MapProjection Projection => _map.Projection;

    /// <inheritdoc/>
    public int Lines => _map.Lines;

    /// <inheritdoc/>
    public int Samples => _map.Samples;

    /// <inheritdoc/>
    public GridWindow Window => _map.Window;

    /// <inheritdoc/>
    public bool MayHaveGaps { get; }

    /// <summary>The same raster with a part.</summary>
    /// <param name="part">Where it lies.</param>
    /// <param name="values">The stored values, row by row.</param>
    /// <param name="hasGaps">Whether any of them is without data.</param>
    public RasterPart With(GridWindow part, Memory<float> values, bool hasGaps) => new(_map, _rule, _sphere, part, values, hasGaps);

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        ReadOnlySpan<float> row = RowAt(line, firstSample, isGap.Length);
        for (int i = 0; i < row.Length; i++)
        {
            isGap[i] = float.IsNaN(row[i]);
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        ReadOnlySpan<float> row = RowAt(line, firstSample, radii.Length);
        for (int i = 0; i < row.Length; i++)
        {
            radii[i] = _sphere + _rule.HeightOf(row[i]);
        }
    }

    private Span<float> RowAt(int line, int sample, int count) =>
        _values.Span.Slice(((line - _part.FirstLine) * _part.Samples) + sample - _part.FirstSample, count);
}
