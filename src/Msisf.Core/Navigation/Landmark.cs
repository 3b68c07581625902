using Msisf.Core.Numerics;

namespace Msisf.Core.Navigation;

/// <summary>A point of a list of landmarks. Immutable.</summary>
/// <param name="Number">The list's row, from 1, without its heading.</param>
/// <param name="Identity">The list's own name of the row, its number where there is none; no two are the same.</param>
/// <param name="Name">Null where the list has none.</param>
/// <param name="Direction">From the Moon's centre, length 1, MOON_ME.</param>
/// <param name="Height">m over the reference radius; null for a point on the terrain.</param>
public sealed record Landmark(int Number, string Identity, string? Name, Vector3D Direction, double? Height);
