using Msisf.Core.Numerics;

namespace Msisf.Core.Surface;

/// <summary>Bounding volumes of the facets of a node: a cap of directions and a box.</summary>
/// <param name="Up">Direction of the node's middle, MOON_ME, length 1.</param>
/// <param name="CapRadius">Angle around <paramref name="Up"/> that contains the directions of the facets.</param>
/// <param name="Box">Box that contains the facets, MOON_ME; its axes point up and along the grid at the middle of the node.</param>
internal readonly record struct NodeBox(Vector3D Up, SineCosine CapRadius, OrientedBox Box);
