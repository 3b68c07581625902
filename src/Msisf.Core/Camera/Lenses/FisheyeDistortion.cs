using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// The fisheye lens of Kannala and Brandt, as OpenCV has it: a ray at an angle t from the axis is measured at the distance
/// t (1 + k1 t2 + k2 t4 + k3 t6 + k4 t8) from the principal point.
/// </summary>
/// <remarks>
/// J. Kannala, S. S. Brandt, IEEE Trans. Pattern Analysis and Machine Intelligence 28 (2006) 1335. The formula is evaluated from
/// measured to ideal, the angle by Newton's method, because that way needs a tangent and no arctangent; eight angles in a vector, as in
/// <see cref="LensMap"/>.
/// </remarks>
public sealed class FisheyeDistortion : Distortion
{
    /// <summary>
    /// rad: what is measured farther out counts as seen at this angle, so that it is refused: fields end at 85 degrees from the axis.
    /// </summary>
    private const double MaxAngle = 1.57;

    /// <summary>From any start, steps of Newton's method after which the angle no longer changes.</summary>
    private const int Steps = 20;

    /// <summary>Distance below which the image is that of a pinhole.</summary>
    private const double Middle = 1e-9;

    private const double AngleError = 1e-12;

    private readonly double[] _k = new double[4];

    /// <summary>Takes the coefficients.</summary>
    /// <param name="k">k1 to k4, or fewer.</param>
    public FisheyeDistortion(ReadOnlySpan<double> k) => k.CopyTo(_k);

    /// <inheritdoc/>
    public override string Name => "fisheye";

    /// <summary>k1 to k4.</summary>
    public override IReadOnlyList<double> Coefficients => _k;

    /// <inheritdoc/>
    public override bool IsNone => false;

    /// <inheritdoc/>
    internal override bool IsFromIdeal => false;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be prepared with unoptimised vectors
    internal override LanePoints Apply(in LanePoints points, out LaneSlopes slopes)
    {
        (Vector512<double> x, Vector512<double> y) = points;
        Vector512<double> square = (x * x) + (y * y);
        Vector512<double> measured = Vector512.Sqrt(square);
        Vector512<double> angle = Vector512.Min(measured, Vector512.Create(MaxAngle));
        for (int step = 0; step < Steps; step++)
        {
            Vector512<double> next = angle - ((Distance(angle, out Vector512<double> slope) - measured) / slope);
            angle = Vector512.Max(Vector512.Min(next, Vector512.Create(MaxAngle)), Vector512<double>.Zero);
        }

        Vector512<double> error = Vector512.Abs(Distance(angle, out Vector512<double> perAngle) - measured);
        Vector512<double> isFound = Vector512.GreaterThan(perAngle, Vector512<double>.Zero)
            & (Vector512.LessThan(error, Vector512.Create(AngleError)) | Vector512.Equals(angle, Vector512.Create(MaxAngle)));
        Vector512<double> tangent = Vector512.ConditionalSelect(isFound, Tangent(angle), Vector512.Create(double.NaN));
        Vector512<double> isMiddle = Vector512.LessThan(measured, Vector512.Create(Middle));
        Vector512<double> factor = Vector512.ConditionalSelect(isMiddle, Vector512<double>.One, tangent / measured);
        Vector512<double> outward = (Vector512<double>.One + (tangent * tangent)) / perAngle;
        Vector512<double> change = Vector512.ConditionalSelect(isMiddle, Vector512<double>.Zero, (outward - factor) / square);
        slopes = new LaneSlopes(factor + (change * x * x), change * x * y, change * x * y, factor + (change * y * y));
        return new LanePoints(factor * x, factor * y);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static Vector512<double> Tangent(Vector512<double> angle)
    {
        // Taylor series of half the angle, below pi/4: the first terms left out are below 2^-53.
        Vector512<double> half = 0.5 * angle;
        Vector512<double> square = half * half;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> sin = Vector512<double>.Zero;
        for (int n = 17; n >= 3; n -= 2)
        {
            sin = (one + sin) * -square / Vector512.Create((double)(n * (n - 1)));
        }

        Vector512<double> cos = Vector512<double>.Zero;
        for (int n = 18; n >= 2; n -= 2)
        {
            cos = (one + cos) * -square / Vector512.Create((double)(n * (n - 1)));
        }

        Vector512<double> tangent = half * (one + sin) / (one + cos);
        return 2.0 * tangent / (one - (tangent * tangent));
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private Vector512<double> Distance(Vector512<double> angle, out Vector512<double> slope)
    {
        Vector512<double> square = angle * angle;
        Vector512<double> one = Vector512<double>.One;
        slope = ((((((((9.0 * _k[3] * square) + Vector512.Create(7.0 * _k[2])) * square) + Vector512.Create(5.0 * _k[1])) * square)
            + Vector512.Create(3.0 * _k[0])) * square) + one);
        return angle * ((((((((_k[3] * square) + Vector512.Create(_k[2])) * square) + Vector512.Create(_k[1])) * square)
            + Vector512.Create(_k[0])) * square) + one);
    }
}
