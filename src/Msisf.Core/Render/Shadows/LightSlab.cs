using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Points of light space with <c>Min &lt;= u AcrossU + v AcrossV &lt;= Max</c>; <c>default</c> contains all points.</summary>
/// <param name="AcrossU">Component along u of the slab's normal, which can have any length.</param>
/// <param name="AcrossV">Component along v of the slab's normal.</param>
/// <param name="Min">Minimum, m times the length of the normal.</param>
/// <param name="Max">Maximum, m times the length of the normal.</param>
internal readonly record struct LightSlab(double AcrossU, double AcrossV, double Min, double Max)
{
    /// <summary>Mask of the points, of eight, that are in the slab.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Holds(Vector512<double> u, Vector512<double> v)
    {
        Vector512<double> across = (u * Vector512.Create(AcrossU)) + (v * Vector512.Create(AcrossV));
        return (uint)(Vector512.GreaterThanOrEqual(across, Vector512.Create(Min))
            & Vector512.LessThanOrEqual(across, Vector512.Create(Max))).ExtractMostSignificantBits();
    }
}
