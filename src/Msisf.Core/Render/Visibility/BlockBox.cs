using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>A box about facets, its axes up, east and north in the middle of a block of cells.</summary>
/// <param name="Up">Direction of the middle, MOON_ME, length 1.</param>
/// <param name="CapRadius">Angle about <paramref name="Up"/> that holds the facets.</param>
/// <param name="Radius">m: the box's centre from the Moon's centre, along <paramref name="Up"/>.</param>
/// <param name="HalfUp">m, MOON_ME: from the box's centre to its top.</param>
/// <param name="HalfEast">m, MOON_ME: to its eastern side.</param>
/// <param name="HalfNorth">m, MOON_ME: to its northern side.</param>
internal readonly record struct BlockBox(
    Vector3D Up, SineCosine CapRadius, double Radius, Vector3D HalfUp, Vector3D HalfEast, Vector3D HalfNorth)
{
    /// <summary>The box itself.</summary>
    public OrientedBox Box => new(Radius * Up, HalfUp, HalfEast, HalfNorth);
}
