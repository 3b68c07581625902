using Msisf.Core.Terrain;

namespace Msisf.Core.Metadata;

/// <summary>One of several elevation models of a frame.</summary>
/// <param name="ProductId">Name of the model, e.g. "LDEM_80S_80M".</param>
/// <param name="IsSynthetic">Whether the model is synthetic, not the real Moon.</param>
/// <param name="Resolution">Resolution of the model.</param>
/// <param name="Drawn">Resolution of the level in the image; null for a model that is left out, because a coarser one is as fine.</param>
public sealed record ElevationPart(string ProductId, bool IsSynthetic, GridResolution Resolution, GridResolution? Drawn);
