namespace Msisf.Core.Surface;

/// <summary>A piece of the surface with bounds that are known without reading its samples.</summary>
/// <param name="Cap">Cap that contains the directions of all points of the piece.</param>
/// <param name="MinRadius">m: minimum radius of the facets.</param>
/// <param name="MaxRadius">m: maximum radius of the facets.</param>
/// <param name="MaxSlope">Upper bound of the tangent of the facets' slopes.</param>
internal readonly record struct TerrainNode(SphericalCap Cap, double MinRadius, double MaxRadius, double MaxSlope);
