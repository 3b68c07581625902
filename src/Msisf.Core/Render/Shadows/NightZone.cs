using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Points of light space whose rays to all parts of the Sun pass below the lowest terrain on their way.</summary>
/// <param name="solidRadius">m: no facet is lower.</param>
/// <param name="slope">Of the Sun's disc.</param>
internal readonly struct NightZone(double solidRadius, double slope)
{
    /// <summary>
    /// For eight points at once. Where w is 0, light space and space are the same, and there a ray is moved by the slope times w at most.
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
