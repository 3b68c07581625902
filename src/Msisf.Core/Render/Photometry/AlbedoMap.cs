namespace Msisf.Core.Render.Photometry;

/// <summary>A map of the Moon's reflectance at one geometry of light and view, with its coarser levels. Immutable.</summary>
public sealed class AlbedoMap
{
    /// <summary>Takes a map.</summary>
    /// <param name="levels">Finest first, each half as wide and high as the one before.</param>
    /// <param name="extent">What the map shows.</param>
    /// <param name="offset">Reflectance of the code 0 (which itself means no data).</param>
    /// <param name="step">Reflectance of a step of the code.</param>
    /// <param name="reference">The geometry of the reflectances.</param>
    public AlbedoMap(
        IReadOnlyList<AlbedoMapLevel> levels, MapExtent extent, double offset, double step, ReferenceGeometry reference)
    {
        Levels = levels;
        Extent = extent;
        Offset = offset;
        Step = step;
        Reference = reference;
    }

    /// <summary>Finest first.</summary>
    public IReadOnlyList<AlbedoMapLevel> Levels { get; }

    /// <summary>What the map shows.</summary>
    public MapExtent Extent { get; }

    /// <summary>Reflectance of the code 0.</summary>
    public double Offset { get; }

    /// <summary>Reflectance of a step of the code.</summary>
    public double Step { get; }

    /// <summary>The geometry of the reflectances.</summary>
    public ReferenceGeometry Reference { get; }
}
