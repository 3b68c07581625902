namespace Msisf.Core.Terrain;

/// <summary>A piece of the surface and what is known of it without reading it.</summary>
/// <param name="Cap">Holds the direction of each of its points.</param>
/// <param name="LeastRadius">m: no point of a facet lies lower.</param>
/// <param name="GreatestRadius">m: no point lies higher.</param>
/// <param name="Steepness">Tangent of an angle that no facet's slope exceeds.</param>
internal readonly record struct TerrainNode(SphericalCap Cap, double LeastRadius, double GreatestRadius, double Steepness);
