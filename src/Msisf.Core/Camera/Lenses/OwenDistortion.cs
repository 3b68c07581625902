using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>Owen's distortion, ideal to measured, as optical navigation has it: radial, decentering and pinwheel terms.</summary>
/// <remarks>W. M. Owen, "Methods of optical navigation", AAS 11-215 (2011); the model of the same name in NASA's GIANT.</remarks>
public sealed class OwenDistortion : Distortion
{
    /// <summary>Distance from the principal point at which the pinwheel's slope, which has no value there, counts as zero.</summary>
    private const double Middle = 1e-200;

    private readonly double[] _e;

    /// <summary>Takes the coefficients.</summary>
    /// <param name="e">e1 to e6, in 1/mm, 1/mm2, 1/mm3, 1/mm4, 1/mm and 1/mm.</param>
    /// <param name="focalLength">mm.</param>
    public OwenDistortion(ReadOnlySpan<double> e, double focalLength)
    {
        double f = focalLength;
        _e = [e[0] * f, e[1] * f * f, e[2] * f * f * f, e[3] * f * f * f * f, e[4] * f, e[5] * f];
    }

    /// <inheritdoc/>
    public override string Name => "owen";

    /// <inheritdoc/>
    public override IReadOnlyList<double> Coefficients => _e;

    /// <inheritdoc/>
    public override bool IsNone => _e.All(coefficient => coefficient == 0.0);

    /// <inheritdoc/>
    internal override bool IsFromIdeal => true;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        (Vector512<double> x, Vector512<double> y) = points;
        Vector512<double> square = (x * x) + (y * y);
        Vector512<double> radius = Vector512.Sqrt(square);
        Vector512<double> perRadius = Vector512<double>.One / Vector512.Max(radius, Vector512.Create(Middle));
        Vector512<double> radial = (((_e[3] * square) + Vector512.Create(_e[1])) * square) + (_e[4] * y) + (_e[5] * x);
        Vector512<double> radialSlope = 2.0 * ((2.0 * _e[3] * square) + Vector512.Create(_e[1]));
        Vector512<double> radialX = (radialSlope * x) + Vector512.Create(_e[5]);
        Vector512<double> radialY = (radialSlope * y) + Vector512.Create(_e[4]);
        Vector512<double> turn = ((_e[2] * square) + Vector512.Create(_e[0])) * radius;
        Vector512<double> turnSlope = ((3.0 * _e[2] * square) + Vector512.Create(_e[0])) * perRadius;
        Vector512<double> turnX = turnSlope * x;
        Vector512<double> turnY = turnSlope * y;
        Vector512<double> one = Vector512<double>.One;
        slopes = new LaneSlopes(
            one + radial + (radialX * x) - (turnX * y),
            (radialY * x) - turn - (turnY * y),
            (radialX * y) + turn + (turnX * x),
            one + radial + (radialY * y) + (turnY * x));
        return new LanePoints(x + (radial * x) - (turn * y), y + (radial * y) + (turn * x));
    }
}
