using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Cuts one axis of light space into equal bins; the first and the last reach to infinity.</summary>
internal readonly struct LightAxis
{
    private readonly double _min;
    private readonly double _binsPerMetre;
    private readonly double _last;

    /// <summary>Lays bins over an interval.</summary>
    /// <param name="min">m.</param>
    /// <param name="max">m.</param>
    /// <param name="bins">How many.</param>
    public LightAxis(double min, double max, int bins)
    {
        // An interval without length has one bin that matters; the scale must be finite.
        _min = min;
        _binsPerMetre = bins / Math.Max(max - min, Tolerances.VertexLattice);
        _last = bins - 1;
    }

    /// <summary>The bin of a coordinate: never less for a greater one, so what overlaps on the axis shares a bin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BinOf(double coordinate) =>
        (int)Math.Min(Math.Max((coordinate - _min) * _binsPerMetre, 0.0), _last);

    /// <summary>The same bins, as whole numbers in doubles.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> BinsOf(Vector512<double> coordinates) => Vector512.Floor(Vector512.MinNative(
        Vector512.MaxNative((coordinates - Vector512.Create(_min)) * Vector512.Create(_binsPerMetre), Vector512<double>.Zero),
        Vector512.Create(_last)));

    /// <summary>m: where a bin begins, but for rounding.</summary>
    public double StartOf(int bin) => _min + (bin / _binsPerMetre);
}
