using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Makes the coarser levels of a raster while its pixels are looked at, band by band from the top.</summary>
/// <param name="Map">The raster, no sample of which is read.</param>
/// <param name="File">Receives the levels; null for nobody.</param>
/// <param name="FirstLevel">The finest of them.</param>
internal sealed record RasterLevels(RasterPart Map, PyramidRows? File, int FirstLevel)
{
    /// <summary>px: height of a band; a strip's width is a multiple of it.</summary>
    public int Step { get; } = File is null ? LeastStep : Math.Max(LeastStep, LodLayout.Side << FirstLevel);

    private const int LeastStep = 512;

    /// <summary>Begins a band.</summary>
    /// <param name="line">Its first line.</param>
    public void Begin(int line, int lines)
    {
        foreach (int row in Rows(line, lines))
        {
            File!.Finest.Begin(row);
        }
    }

    /// <summary>Reduces a part of a band. Several threads may do so at once.</summary>
    /// <param name="part">Where it lies: at whole blocks, or the end of the map.</param>
    /// <param name="values">The stored values, row by row.</param>
    /// <param name="hasGaps">Whether any of them is without data.</param>
    public void Reduce(GridWindow part, Memory<float> values, bool hasGaps)
    {
        if (File is null)
        {
            return;
        }

        BlockReducer reducer = new(Map.With(part, values, hasGaps), FirstLevel, keepsGaps: true);
        int last = File.Finest.ColumnOf(part.EndSample - 1, FirstLevel);
        foreach (int row in Rows(part.FirstLine, part.Lines))
        {
            for (int column = File.Finest.ColumnOf(part.FirstSample, FirstLevel); column <= last; column++)
            {
                reducer.Reduce(row, column, File.Finest.Block(row, column));
            }
        }
    }

    /// <summary>Writes a band all parts of which are reduced.</summary>
    /// <param name="line">Its first line.</param>
    public void Write(int line, int lines)
    {
        foreach (int row in Rows(line, lines))
        {
            File!.Write(row);
        }
    }

    /// <summary>The rows of blocks of a band.</summary>
    private IEnumerable<int> Rows(int line, int lines)
    {
        int first = File?.Finest.RowOf(line, FirstLevel) ?? 0;
        return Enumerable.Range(first, File is null ? 0 : File.Finest.RowOf(line + lines - 1, FirstLevel) - first + 1);
    }
}

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
