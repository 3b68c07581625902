using Msisf.Core.Numerics;

namespace Msisf.Core.Surface;

/// <summary>A vertex of a model that a seam uses too.</summary>
/// <param name="Position">m, MOON_ME, on the lattice of its model.</param>
/// <param name="Part">Number of the model.</param>
/// <param name="Line">Line of the vertex in the model's mesh.</param>
/// <param name="Sample">Sample of the vertex.</param>
internal readonly record struct SeamVertex(Vector3D Position, int Part, int Line, int Sample);
