using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Samples of a raster that are in memory: those of a part of it.</summary>
internal sealed class RasterPart : ChangedGrid
{
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

    private RasterPart(ITerrainGrid map, HeightRule rule, double sphere, GridWindow part, Memory<float> values, bool hasGaps)
        : base(map) => (_rule, _sphere, _part, _values, MayHaveGaps) = (rule, sphere, part, values, hasGaps);

    public override bool MayHaveGaps { get; }

    /// <summary>The same raster with a part.</summary>
    /// <param name="part">Where it lies.</param>
    /// <param name="values">The stored values, row by row.</param>
    /// <param name="hasGaps">Whether any of them is without data.</param>
    public RasterPart With(GridWindow part, Memory<float> values, bool hasGaps) => new(Source, _rule, _sphere, part, values, hasGaps);

    public override bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) => MayHaveGaps;

    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) => null;

    public override void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        ReadOnlySpan<float> row = RowAt(line, firstSample, isGap.Length);
        for (int i = 0; i < row.Length; i++)
        {
            isGap[i] = float.IsNaN(row[i]);
        }
    }

    public override void ReadRadii(int line, int firstSample, Span<double> radii)
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
