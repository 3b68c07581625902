using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Points of light space with <c>Least &lt;= u AcrossU + v AcrossV &lt;= Greatest</c>; <c>default</c> holds them all.</summary>
/// <param name="AcrossU">Any length.</param>
/// <param name="AcrossV">Any length.</param>
/// <param name="Least">m times that length.</param>
/// <param name="Greatest">m times that length.</param>
internal readonly record struct LightSlab(double AcrossU, double AcrossV, double Least, double Greatest)
{
    /// <summary>A bit for each of eight points that is in it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Holds(Vector512<double> u, Vector512<double> v)
    {
        Vector512<double> across = (u * Vector512.Create(AcrossU)) + (v * Vector512.Create(AcrossV));
        return (uint)(Vector512.GreaterThanOrEqual(across, Vector512.Create(Least))
            & Vector512.LessThanOrEqual(across, Vector512.Create(Greatest))).ExtractMostSignificantBits();
    }
}
