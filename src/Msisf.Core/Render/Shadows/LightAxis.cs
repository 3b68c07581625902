using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Divides one axis of light space into equal bins; the first and the last bin extend to infinity.</summary>
internal readonly struct LightAxis
{
    private readonly double _min;
    private readonly double _binsPerMetre;
    private readonly double _last;

    /// <summary>Divides an interval into bins.</summary>
    /// <param name="min">Minimum coordinate, m.</param>
    /// <param name="max">Maximum coordinate, m.</param>
    public LightAxis(double min, double max, int bins)
    {
        // The minimum length keeps the scale finite for an interval of length 0.
        _min = min;
        _binsPerMetre = bins / Math.Max(max - min, Tolerances.VertexLattice);
        _last = bins - 1;
    }

    /// <summary>The bin of a coordinate, m; it never decreases with the coordinate, so intervals that overlap share a bin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BinOf(double coordinate) =>
        (int)Math.Min(Math.Max((coordinate - _min) * _binsPerMetre, 0.0), _last);

    /// <summary>The bins of eight coordinates, as whole numbers in doubles.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> BinsOf(Vector512<double> coordinates) => Vector512.Floor(Vector512.MinNative(
        Vector512.MaxNative((coordinates - Vector512.Create(_min)) * Vector512.Create(_binsPerMetre), Vector512<double>.Zero),
        Vector512.Create(_last)));

    /// <summary>Minimum coordinate of a bin, m, up to rounding errors.</summary>
    public double StartOf(int bin) => _min + (bin / _binsPerMetre);
}

/// <summary>A rectangle of bins of a grid; the last column and the last row are included.</summary>
internal readonly record struct GridRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    /// <summary>Number of bins.</summary>
    public int Count => (LastColumn - FirstColumn + 1) * (LastRow - FirstRow + 1);
}
