using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>A body as it is seen at sixteen steps.</summary>
/// <param name="Tangent">Tangent of the elevation of its middle.</param>
/// <param name="Column">Its azimuth in columns.</param>
/// <param name="Slope">Tangent of its angular radius.</param>
/// <param name="PerCosine">One over the cosine of the elevation of its middle.</param>
/// <param name="Width">Columns from its middle to its edge.</param>
internal readonly record struct SeenBody(
    Vector512<float> Tangent, Vector512<float> Column, Vector512<float> Slope, Vector512<float> PerCosine, Vector512<float> Width)
{
    /// <summary>Tangent of the horizon's elevation beside the body's middle.</summary>
    /// <param name="table">The horizon.</param>
    /// <param name="offset">To the right, in the body's radii.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> TangentAt(HorizonTable table, float offset) => table.At(Column + (Vector512.Create(offset) * Width));

    /// <summary>The height of a horizon over the body's middle, in its radii.</summary>
    /// <param name="horizon">Tangent of the horizon's elevation.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> HeightOf(Vector512<float> horizon) =>
        (horizon - Tangent) / ((Vector512<float>.One + (horizon * Tangent)) * Slope);
}
