namespace Msisf.Core.Terrain;

/// <summary>A model whose heights are all raised by the same. Safe for several threads.</summary>
/// <param name="grid">The model, which is not of the whole Moon.</param>
/// <param name="offset">m.</param>
public sealed class OffsetGrid(ITerrainGrid grid, double offset) : ChangedGrid(grid)
{
    /// <summary>m.</summary>
    public double Offset => offset;

    /// <inheritdoc/>
    public override (double Min, double Max) RadiusLimits => (Source.RadiusLimits.Min + offset, Source.RadiusLimits.Max + offset);

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) =>
        Source.BoundsOf(firstLine, lines, firstSample, samples) is { } known
            ? known with { Min = known.Min + offset, Max = known.Max + offset }
            : null;

    /// <inheritdoc/>
    public override void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        Source.ReadRadii(line, firstSample, radii);
        for (int i = 0; i < radii.Length; i++)
        {
            radii[i] += offset;
        }
    }
}
