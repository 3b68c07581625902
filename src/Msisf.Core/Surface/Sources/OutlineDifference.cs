using Msisf.Core.Numerics;

namespace Msisf.Core.Surface.Sources;

/// <summary>How much higher a model is than the ground of a coarser one, at a sample of its outline.</summary>
/// <param name="Place">The sample's place on the reference sphere, m, MOON_ME.</param>
/// <param name="Height">m: the finer model's height less that of the coarser one.</param>
/// <param name="Length">m of the outline for which the sample stands.</param>
internal readonly record struct OutlineDifference(Vector3D Place, double Height, double Length);
