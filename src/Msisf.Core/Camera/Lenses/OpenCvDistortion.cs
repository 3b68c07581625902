using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// The distortion of OpenCV, ideal to measured: rational radial terms, tangential and thin prism terms. Brown and Conrady's is the one with
/// k4 to k6 and s1 to s4 zero.
/// </summary>
/// <remarks>OpenCV 4, Camera Calibration and 3D Reconstruction; D. C. Brown, Photogrammetric Engineering 32 (1966) 444.</remarks>
public sealed class OpenCvDistortion : Distortion
{
    private readonly double[] _k = new double[6];
    private readonly double[] _p = new double[2];
    private readonly double[] _s = new double[4];

    /// <summary>Takes the coefficients.</summary>
    /// <param name="k">k1 to k6, or fewer.</param>
    /// <param name="p">p1 and p2.</param>
    /// <param name="s">s1 to s4; none for zeros.</param>
    public OpenCvDistortion(ReadOnlySpan<double> k, ReadOnlySpan<double> p, ReadOnlySpan<double> s = default)
    {
        k.CopyTo(_k);
        p.CopyTo(_p);
        s.CopyTo(_s);
    }

    /// <inheritdoc/>
    public override string Name => "opencv";

    /// <summary>In OpenCV's order: k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4.</summary>
    public override IReadOnlyList<double> Coefficients => [_k[0], _k[1], _p[0], _p[1], _k[2], _k[3], _k[4], _k[5], .. _s];

    /// <inheritdoc/>
    public override bool IsNone => Coefficients.All(coefficient => coefficient == 0.0);

    /// <inheritdoc/>
    internal override bool IsFromIdeal => true;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        (Vector512<double> x, Vector512<double> y) = points;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> x2 = x + x;
        Vector512<double> y2 = y + y;
        Vector512<double> square = (x * x) + (y * y);
        Vector512<double> below = one + (((((_k[5] * square) + Vector512.Create(_k[4])) * square) + Vector512.Create(_k[3])) * square);
        Vector512<double> above = one + (((((_k[2] * square) + Vector512.Create(_k[1])) * square) + Vector512.Create(_k[0])) * square);
        Vector512<double> belowSlope = (((3.0 * _k[5] * square) + Vector512.Create(2.0 * _k[4])) * square) + Vector512.Create(_k[3]);
        Vector512<double> aboveSlope = (((3.0 * _k[2] * square) + Vector512.Create(2.0 * _k[1])) * square) + Vector512.Create(_k[0]);
        Vector512<double> factor = above / below;
        Vector512<double> factorSlope = (aboveSlope - (factor * belowSlope)) / below;
        Vector512<double> tangentialX = (2.0 * _p[0] * x) + (2.0 * _p[1] * y);
        Vector512<double> prismX = Vector512.Create(_s[0]) + (2.0 * _s[1] * square);
        Vector512<double> prismY = Vector512.Create(_s[2]) + (2.0 * _s[3] * square);
        slopes = new LaneSlopes(
            factor + (x * factorSlope * x2) + (2.0 * _p[0] * y) + (6.0 * _p[1] * x) + (prismX * x2),
            (x * factorSlope * y2) + tangentialX + (prismX * y2),
            (y * factorSlope * x2) + tangentialX + (prismY * x2),
            factor + (y * factorSlope * y2) + (6.0 * _p[0] * y) + (2.0 * _p[1] * x) + (prismY * y2));
        return new LanePoints(
            (x * factor) + (_p[0] * x2 * y) + (_p[1] * (square + (x2 * x))) + (((_s[1] * square) + Vector512.Create(_s[0])) * square),
            (y * factor) + (_p[0] * (square + (y2 * y))) + (_p[1] * x2 * y) + (((_s[3] * square) + Vector512.Create(_s[2])) * square));
    }
}
