namespace Msisf.Core.Terrain;

/// <summary>A model that is another one but for what is changed. Safe for several threads if the changes are.</summary>
/// <param name="grid">The other model.</param>
public abstract class ChangedGrid(ITerrainGrid grid) : ITerrainGrid
{
    /// <summary>The model as it is.</summary>
    public ITerrainGrid Source => grid;

    /// <inheritdoc/>
    public string ProductId => grid.ProductId;

    /// <inheritdoc/>
    public virtual bool IsWholeBody => grid.IsWholeBody;

    /// <inheritdoc/>
    public virtual MapProjection Projection => grid.Projection;

    /// <inheritdoc/>
    public int Lines => grid.Lines;

    /// <inheritdoc/>
    public int Samples => grid.Samples;

    /// <inheritdoc/>
    public virtual GridWindow Window => grid.Window;

    /// <inheritdoc/>
    public double ReferenceRadius => grid.ReferenceRadius;

    /// <inheritdoc/>
    public virtual (double Min, double Max) RadiusLimits => grid.RadiusLimits;

    /// <inheritdoc/>
    public bool HoldsMeans => grid.HoldsMeans;

    /// <inheritdoc/>
    public virtual bool MayHaveGaps => grid.MayHaveGaps;

    /// <inheritdoc/>
    public virtual IReadOnlyList<ITerrainGrid> StoredLevels => [];

    /// <inheritdoc/>
    public virtual bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) =>
        grid.MayHaveGapsIn(firstLine, lines, firstSample, samples);

    /// <inheritdoc/>
    public virtual void ReadGaps(int line, int firstSample, Span<bool> isGap) => grid.ReadGaps(line, firstSample, isGap);

    /// <inheritdoc/>
    public abstract KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples);

    /// <inheritdoc/>
    public abstract void ReadRadii(int line, int firstSample, Span<double> radii);

    /// <inheritdoc/>
    public virtual bool IsBlended(int line, int sample) => grid.IsBlended(line, sample);

    /// <inheritdoc/>
    public virtual void Prefetch(int firstLine, int lines, int firstSample, int samples) =>
        grid.Prefetch(firstLine, lines, firstSample, samples);

    /// <inheritdoc/>
    public void ReleasePages() => grid.ReleasePages();
}
