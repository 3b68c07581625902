using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// Measured to ideal by a factor that depends on the distance from the principal point: 1 + k1 r2 + k2 r4 + k3 r6, or one divided by it.
/// Instrument kernels and ISIS have it so.
/// </summary>
public sealed class RadialDistortion : Distortion
{
    private readonly double[] _k = new double[3];
    private readonly bool _isDivision;

    /// <summary>Takes the coefficients.</summary>
    /// <param name="k">k1 to k3, or fewer, in 1/mm2, 1/mm4 and 1/mm6.</param>
    /// <param name="isDivision">Whether the measured coordinates are divided by the sum; otherwise they are multiplied with it.</param>
    /// <param name="focalLength">mm.</param>
    public RadialDistortion(ReadOnlySpan<double> k, bool isDivision, double focalLength)
    {
        double unit = 1.0;
        for (int i = 0; i < k.Length; i++)
        {
            unit *= focalLength * focalLength;
            _k[i] = k[i] * unit;
        }

        _isDivision = isDivision;
    }

    /// <inheritdoc/>
    public override string Name => _isDivision ? "radial-division" : "radial-factor";

    /// <inheritdoc/>
    public override IReadOnlyList<double> Coefficients => _k;

    /// <inheritdoc/>
    public override bool IsNone => _k.All(coefficient => coefficient == 0.0);

    /// <inheritdoc/>
    internal override bool IsFromIdeal => false;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        (Vector512<double> x, Vector512<double> y) = points;
        Vector512<double> square = (x * x) + (y * y);
        Vector512<double> sum = (((((_k[2] * square) + Vector512.Create(_k[1])) * square) + Vector512.Create(_k[0])) * square)
            + Vector512<double>.One;
        Vector512<double> slope = (((3.0 * _k[2] * square) + Vector512.Create(2.0 * _k[1])) * square) + Vector512.Create(_k[0]);
        Vector512<double> factor = _isDivision ? Vector512<double>.One / sum : sum;
        Vector512<double> twice = 2.0 * (_isDivision ? -slope * factor * factor : slope);
        slopes = new LaneSlopes(factor + (twice * x * x), twice * x * y, twice * x * y, factor + (twice * y * y));
        return new LanePoints(factor * x, factor * y);
    }
}
