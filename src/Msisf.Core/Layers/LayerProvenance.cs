namespace Msisf.Core.Layers;

/// <summary>What the layers' files say of a frame beyond its metadata.</summary>
/// <param name="ElevationProduct">Name of the elevation model, e.g. "LDEM_64".</param>
/// <param name="MeshPixelsPerDegree">
/// px/deg of the grid in which cells are counted: the model's own, or that of its level of detail.
/// </param>
/// <param name="LevelOfDetail">0 is the model itself.</param>
/// <param name="Renderer">E.g. "native".</param>
public sealed record LayerProvenance(string ElevationProduct, int MeshPixelsPerDegree, int LevelOfDetail, string Renderer);
