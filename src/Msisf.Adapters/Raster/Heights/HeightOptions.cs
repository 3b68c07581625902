namespace Msisf.Adapters.Raster.Heights;

/// <summary>What the user says of the values of an elevation model; <c>default</c> is nothing.</summary>
/// <param name="Scale">m a step of the stored values; null for what the file, or the table of known products, says.</param>
/// <param name="Offset">m that are added to all heights.</param>
/// <param name="HoldsMeans">Whether samples are means of cells (<see cref="Core.Terrain.ITerrainGrid.HoldsMeans"/>).</param>
public readonly record struct HeightOptions(double? Scale, double? Offset, bool? HoldsMeans = null)
{
    /// <summary>Whether nothing is said.</summary>
    public bool IsEmpty => this == default;
}
