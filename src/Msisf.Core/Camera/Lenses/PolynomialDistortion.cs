using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// Measured to ideal by polynomials that are added to x and to y, of the distance from the principal point or of x itself. The kernels of
/// Kaguya's line cameras have it so.
/// </summary>
/// <param name="x">What is added to x: up to four coefficients by increasing power, in mm, 1, 1/mm and 1/mm2.</param>
/// <param name="y">What is added to y.</param>
/// <param name="isRadial">Whether the distance from the principal point is the argument; otherwise it is x.</param>
/// <param name="focalLength">mm.</param>
public sealed class PolynomialDistortion(ReadOnlySpan<double> x, ReadOnlySpan<double> y, bool isRadial, double focalLength) : Distortion
{
    private const double Middle = 1e-200;

    private readonly double[] _x = Normalised(x, focalLength);
    private readonly double[] _y = Normalised(y, focalLength);

    /// <inheritdoc/>
    public override string Name => isRadial ? "polynomial-radius" : "polynomial-x";

    /// <inheritdoc/>
    public override IReadOnlyList<double> Coefficients => [.. _x, .. _y];

    /// <inheritdoc/>
    public override bool IsNone => _x.Concat(_y).All(coefficient => coefficient == 0.0);

    /// <inheritdoc/>
    internal override bool IsFromIdeal => false;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        (Vector512<double> x, Vector512<double> y) = points;
        Vector512<double> radius = Vector512.Sqrt((x * x) + (y * y));
        Vector512<double> perRadius = Vector512<double>.One / Vector512.Max(radius, Vector512.Create(Middle));
        Vector512<double> argument = isRadial ? radius : x;
        Vector512<double> alongX = isRadial ? x * perRadius : Vector512<double>.One;
        Vector512<double> alongY = isRadial ? y * perRadius : Vector512<double>.Zero;
        Vector512<double> slopeX = Slope(_x, argument);
        Vector512<double> slopeY = Slope(_y, argument);
        Vector512<double> one = Vector512<double>.One;
        slopes = new LaneSlopes(one + (slopeX * alongX), slopeX * alongY, slopeY * alongX, one + (slopeY * alongY));
        return new LanePoints(x + Value(_x, argument), y + Value(_y, argument));
    }

    private static Vector512<double> Value(double[] of, Vector512<double> at) =>
        (((((of[3] * at) + Vector512.Create(of[2])) * at) + Vector512.Create(of[1])) * at) + Vector512.Create(of[0]);

    private static Vector512<double> Slope(double[] of, Vector512<double> at) =>
        (((3.0 * of[3] * at) + Vector512.Create(2.0 * of[2])) * at) + Vector512.Create(of[1]);

    private static double[] Normalised(ReadOnlySpan<double> coefficients, double focalLength)
    {
        double[] result = new double[4];
        double unit = 1.0 / focalLength;
        for (int i = 0; i < coefficients.Length; i++)
        {
            result[i] = coefficients[i] * unit;
            unit *= focalLength;
        }

        return result;
    }
}
