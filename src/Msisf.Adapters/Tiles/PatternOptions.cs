namespace Msisf.Adapters.Tiles;

/// <summary>The kind of patterns; <c>default</c> is mesh2 without a margin.</summary>
public readonly record struct PatternOptions
{
    /// <summary>Degrees: far more than any margin needs; the tile's lattice can hold it.</summary>
    public const double MaxMarginDegrees = 1.0;

    /// <summary>Checks the options.</summary>
    /// <param name="marginDegrees">
    /// Overlap with the neighbours on each side, 0 to 1 degrees (thesis: 0.5 at 4 and 16 px/deg, 0.1 at 64); rounded up to whole samples.
    /// </param>
    /// <param name="format">The form of the mesh.</param>
    /// <exception cref="BadInputException">The margin is out of range.</exception>
    public PatternOptions(double marginDegrees, PatternFormat format)
    {
        if (!(marginDegrees >= 0.0 && marginDegrees <= MaxMarginDegrees))
        {
            throw new BadInputException(Invariant(
                $"The margin is {marginDegrees:R} degrees; 0 (tiles meet without one) to {MaxMarginDegrees:R} degrees are possible."));
        }

        MarginDegrees = marginDegrees;
        Format = format;
    }

    /// <summary>Overlap with the neighbours on each side, degrees.</summary>
    public double MarginDegrees { get; }

    /// <summary>The form of the mesh.</summary>
    public PatternFormat Format { get; }

    /// <summary>The margin in samples, rounded up.</summary>
    public int MarginSamples(int pixelsPerDegree) => (int)Math.Ceiling(MarginDegrees * pixelsPerDegree);
}
