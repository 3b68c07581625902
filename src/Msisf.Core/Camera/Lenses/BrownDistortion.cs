using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// Brown's corrections, measured to ideal, as reports of calibrations have them: radial and decentring terms about a centre of their own,
/// and terms along a fixed direction.
/// </summary>
/// <remarks>D. C. Brown, Photogrammetric Engineering 32 (1966) 444; the kernels of Clementine's UVVIS, of M3 and of Apollo's metric
/// cameras.</remarks>
public sealed class BrownDistortion : Distortion
{
    private readonly double[] _k = new double[4];
    private readonly double[] _p = new double[2];
    private readonly double[] _s = new double[4];
    private readonly (double X, double Y) _center;

    /// <summary>Takes the coefficients.</summary>
    /// <param name="k">k0 to k3, or fewer, in 1, 1/mm2, 1/mm4 and 1/mm6.</param>
    /// <param name="p">p1 and p2, 1/mm; none for zeros.</param>
    /// <param name="s">s1 and s2 along x, s3 and s4 along y, in 1/mm and 1/mm3 each; none for zeros.</param>
    /// <param name="center">The centre of the terms, mm from the principal point.</param>
    /// <param name="focalLength">mm.</param>
    public BrownDistortion(
        ReadOnlySpan<double> k, ReadOnlySpan<double> p, ReadOnlySpan<double> s, (double X, double Y) center, double focalLength)
    {
        Scale(k, _k, 1.0, focalLength * focalLength);
        Scale(p, _p, focalLength, 1.0);
        double cube = focalLength * focalLength * focalLength;
        for (int i = 0; i < s.Length; i++)
        {
            _s[i] = s[i] * (i % 2 == 0 ? focalLength : cube);
        }

        _center = (center.X / focalLength, center.Y / focalLength);
    }

    /// <inheritdoc/>
    public override string Name => "brown";

    /// <summary>k0, k1, k2, k3, p1, p2, s1, s2, s3, s4, x0, y0.</summary>
    public override IReadOnlyList<double> Coefficients => [.. _k, .. _p, .. _s, _center.X, _center.Y];

    /// <inheritdoc/>
    public override bool IsNone => Coefficients.All(coefficient => coefficient == 0.0);

    /// <inheritdoc/>
    internal override bool IsFromIdeal => false;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        Vector512<double> x = points.X - Vector512.Create(_center.X);
        Vector512<double> y = points.Y - Vector512.Create(_center.Y);
        Vector512<double> x2 = x + x;
        Vector512<double> y2 = y + y;
        Vector512<double> square = (x * x) + (y * y);
        Vector512<double> factor = (((((_k[3] * square) + Vector512.Create(_k[2])) * square) + Vector512.Create(_k[1])) * square)
            + Vector512.Create(_k[0]);
        Vector512<double> slope = (((3.0 * _k[3] * square) + Vector512.Create(2.0 * _k[2])) * square) + Vector512.Create(_k[1]);
        Vector512<double> fixedX = Vector512.Create(_s[0]) + (2.0 * _s[1] * square);
        Vector512<double> fixedY = Vector512.Create(_s[2]) + (2.0 * _s[3] * square);
        Vector512<double> diagonal = Vector512<double>.One + factor + (_p[0] * x2) + (_p[1] * y2);
        Vector512<double> crossX = (_p[0] * y2) + (_p[1] * x2);
        slopes = new LaneSlopes(
            diagonal + (x * slope * x2) + (2.0 * _p[0] * x2) + (fixedX * x2),
            (x * slope * y2) + crossX + (fixedX * y2),
            (y * slope * x2) + crossX + (fixedY * x2),
            diagonal + (y * slope * y2) + (2.0 * _p[1] * y2) + (fixedY * y2));
        return new LanePoints(
            points.X + (x * factor) + (_p[0] * (square + (x2 * x))) + (_p[1] * x2 * y)
                + (((_s[1] * square) + Vector512.Create(_s[0])) * square),
            points.Y + (y * factor) + (_p[0] * x2 * y) + (_p[1] * (square + (y2 * y)))
                + (((_s[3] * square) + Vector512.Create(_s[2])) * square));
    }

    private static void Scale(ReadOnlySpan<double> from, Span<double> to, double first, double step)
    {
        double unit = first;
        for (int i = 0; i < from.Length; i++)
        {
            to[i] = from[i] * unit;
            unit *= step;
        }
    }
}
