namespace Msisf.Core.Terrain;

/// <summary>A model whose heights are all raised by the same. Safe for several threads.</summary>
/// <param name="grid">The model, which is not of the whole Moon.</param>
/// <param name="offset">m.</param>
public sealed class OffsetGrid(ITerrainGrid grid, double offset) : ITerrainGrid
{
    /// <summary>The model as it is.</summary>
    public ITerrainGrid Source => grid;

    /// <summary>m.</summary>
    public double Offset => offset;

    /// <inheritdoc/>
    public string ProductId => grid.ProductId;

    /// <inheritdoc/>
    public MapProjection Projection => grid.Projection;

    /// <inheritdoc/>
    public int Lines => grid.Lines;

    /// <inheritdoc/>
    public int Samples => grid.Samples;

    /// <inheritdoc/>
    public GridWindow Window => grid.Window;

    /// <inheritdoc/>
    public double ReferenceRadius => grid.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => (grid.RadiusLimits.Min + offset, grid.RadiusLimits.Max + offset);

    /// <inheritdoc/>
    public bool MayHaveGaps => grid.MayHaveGaps;

    /// <inheritdoc/>
    public bool HoldsMeans => grid.HoldsMeans;

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap) => grid.ReadGaps(line, firstSample, isGap);

    /// <inheritdoc/>
    public bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) =>
        grid.MayHaveGapsIn(firstLine, lines, firstSample, samples);

    /// <inheritdoc/>
    public KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) =>
        grid.BoundsOf(firstLine, lines, firstSample, samples) is { } known
            ? known with { Min = known.Min + offset, Max = known.Max + offset }
            : null;

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        grid.ReadRadii(line, firstSample, radii);
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] += offset;
        }
    }

    /// <inheritdoc/>
    public void Prefetch(int firstLine, int lines, int firstSample, int samples) => grid.Prefetch(firstLine, lines, firstSample, samples);

    /// <inheritdoc/>
    public void ReleasePages() => grid.ReleasePages();
}
