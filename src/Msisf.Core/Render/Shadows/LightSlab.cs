using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Points of light space with <c>Minimum &lt;= u AcrossU + v AcrossV &lt;= Maximum</c>; <c>default</c> holds them all.</summary>
/// <param name="AcrossU">Any length.</param>
/// <param name="AcrossV">Any length.</param>
/// <param name="Min">m times that length.</param>
/// <param name="Max">m times that length.</param>
internal readonly record struct LightSlab(double AcrossU, double AcrossV, double Min, double Max)
{
    /// <summary>A bit for each of eight points that is in it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Holds(Vector512<double> u, Vector512<double> v)
    {
        Vector512<double> across = (u * Vector512.Create(AcrossU)) + (v * Vector512.Create(AcrossV));
        return (uint)(Vector512.GreaterThanOrEqual(across, Vector512.Create(Min))
            & Vector512.LessThanOrEqual(across, Vector512.Create(Max))).ExtractMostSignificantBits();
    }
}
