namespace Msisf.Synthesis;

/// <summary>The craters and boulders of a seed that were found, for all layers of detail. Safe for several threads.</summary>
internal sealed class GroundMemory
{
    /// <summary>The craters of all diameters, also those that a layer does not have.</summary>
    public CellMemory<PlacedCrater> Craters { get; } = new();

    /// <summary>The boulders.</summary>
    public CellMemory<Boulder> Boulders { get; } = new();
}
