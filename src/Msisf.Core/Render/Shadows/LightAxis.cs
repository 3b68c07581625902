using System.Runtime.CompilerServices;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Cuts one axis of light space into equal bins; the first and the last reach to infinity.</summary>
internal readonly struct LightAxis
{
    private readonly double _least;
    private readonly double _binsPerMetre;
    private readonly double _last;

    /// <summary>Lays bins over an interval.</summary>
    /// <param name="least">m.</param>
    /// <param name="greatest">m.</param>
    /// <param name="bins">How many.</param>
    public LightAxis(double least, double greatest, int bins)
    {
        // An interval without length has one bin that matters; the scale must be finite.
        _least = least;
        _binsPerMetre = bins / Math.Max(greatest - least, Tolerances.VertexLattice);
        _last = bins - 1;
    }

    /// <summary>The bin of a coordinate: never less for a greater one, so what overlaps on the axis shares a bin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BinOf(double coordinate) =>
        (int)Math.Min(Math.Max((coordinate - _least) * _binsPerMetre, 0.0), _last);
}
