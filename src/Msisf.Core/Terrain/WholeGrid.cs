namespace Msisf.Core.Terrain;

/// <summary>
/// A grid of latitude and longitude that has a sample for each place of the whole Moon, as the model of it that it is. Safe for several
/// threads if the grid is.
/// </summary>
/// <param name="grid">A grid whose window is all of it, without places without data.</param>
public sealed class WholeGrid(ITerrainGrid grid) : ChangedGrid(grid), IGlobalGrid
{
    /// <inheritdoc/>
    public int PixelsPerDegree { get; } = ((Equirectangular)grid.Projection).PixelsPerDegree;

    /// <inheritdoc/>
    public override bool IsWholeBody => true;

    /// <inheritdoc/>
    public override IReadOnlyList<ITerrainGrid> StoredLevels => [.. Source.StoredLevels.Select(level => new WholeGrid(level))];

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) =>
        Source.BoundsOf(firstLine, lines, firstSample, samples);

    /// <inheritdoc/>
    public override void ReadRadii(int line, int firstSample, Span<double> radii) => Source.ReadRadii(line, firstSample, radii);
}
