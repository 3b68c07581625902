using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The points of light space for which all rays to the Sun pass below the lowest terrain, so that they are in shadow.</summary>
/// <param name="solidRadius">Lower bound of the distance of all facets from the Moon's centre, m; 0 for no zone.</param>
/// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
internal readonly struct NightZone(double solidRadius, double slope)
{
    /// <summary>
    /// Tells which of eight points are in the zone. In the plane w = 0 light space does not change lengths, and a ray to a part of the
    /// disc meets this plane at most the slope times w away from the ray to the disc's centre.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> Holds(Vector512<double> u, Vector512<double> v, Vector512<double> w)
    {
        Vector512<double> room = Vector512.Create(solidRadius) - (Vector512.Create(slope) * w);
        return Vector512.GreaterThan(w, Vector512<double>.Zero)
            & Vector512.GreaterThan(room, Vector512<double>.Zero)
            & Vector512.LessThan((u * u) + (v * v), room * room);
    }
}
