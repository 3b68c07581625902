using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>What holds the facets of a node.</summary>
/// <param name="Up">Direction of the node's middle, MOON_ME, length 1.</param>
/// <param name="CapRadius">Angle about <paramref name="Up"/> that holds the facets.</param>
/// <param name="Box">A box about the facets, MOON_ME; its axes point up, east and north in the middle of the node.</param>
internal readonly record struct NodeBox(Vector3D Up, SineCosine CapRadius, OrientedBox Box);
