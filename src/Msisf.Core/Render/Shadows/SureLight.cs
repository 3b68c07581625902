using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Whether the Sun reaches a piece of a facet that faces it.</summary>
internal enum PieceLight
{
    /// <summary>Its points may differ.</summary>
    Unsure,

    /// <summary>It reaches all points.</summary>
    Lit,

    /// <summary>It reaches none.</summary>
    Dark,
}

/// <summary>
/// Tells of pieces of facets that face the Sun whether it certainly reaches all or none of their points, as <see cref="ShadowPass.Run"/>
/// or, for all of the disc, <see cref="PenumbraPass.Run"/> would find it for each. Safe for several threads.
/// </summary>
/// <param name="frame">Light space.</param>
/// <param name="solidRadius">Radius of the night zone, m; 0 for none.</param>
/// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
/// <param name="casters">The facets that face away, from the disc at least in part.</param>
internal sealed class SureLight(LightFrame frame, double solidRadius, double slope, CasterDepths casters)
{
    /// <summary>m: far above the rounding errors of points in space and in light space, and far below what one sees.</summary>
    public const double Margin = 1e-3;

    /// <summary>
    /// More than that of <see cref="SunDisc.MinCosine"/>, also where the cosine is another one at the other end of a piece.
    /// </summary>
    private const double DiscMargin = 1.05;

    /// <summary>
    /// Cosine of the incidence angle to the Sun's centre from which on a facet faces all of the Sun, and with the other sign none of it.
    /// </summary>
    public double LeastCosine => Math.Max(Tolerances.FacingOfFacet, DiscMargin * slope);

    /// <summary>The light on a piece.</summary>
    /// <param name="x">m, body-fixed x of four points; the piece lies within their convex hull.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PieceLight Of(Vector256<double> x, Vector256<double> y, Vector256<double> z)
    {
        Vector256<double> distance = Vector256.Create(frame.SunDistance);
        Vector256<double> w = Dot(x, y, z, frame.AxisW);
        Vector256<double> scale = distance / (distance + w);
        Vector256<double> u = scale * Dot(x, y, z, frame.AxisU);
        Vector256<double> v = scale * Dot(x, y, z, frame.AxisV);
        w = scale * w;
        LightBox box = new(Min(u) - Margin, Margin - Min(-u), Min(v) - Margin, Margin - Min(-v));
        double maxDepth = Margin - Min(-w);
        if (maxDepth > 0.0)
        {
            double within = solidRadius - Margin;
            double aside = Math.Max(0.0, Math.Max(box.MinU, -box.MaxU));
            double along = Math.Max(0.0, Math.Max(box.MinV, -box.MaxV));
            if (slope == 0.0 && within > 0.0 && Vector256.LessThanAll((u * u) + (v * v), Vector256.Create(within * within))
                && Vector256.GreaterThanAll(w, Vector256.Create(Margin)))
            {
                return PieceLight.Dark;
            }

            if ((aside * aside) + (along * along) < solidRadius * solidRadius)
            {
                return PieceLight.Unsure;
            }
        }

        bool mayHide = slope == 0.0 ? casters.MayHide(in box, maxDepth) : casters.MayHide(in box, maxDepth, slope);
        return mayHide ? PieceLight.Unsure : PieceLight.Lit;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Min(Vector256<double> values)
    {
        Vector128<double> two = Vector128.MinNative(values.GetLower(), values.GetUpper());
        return Math.Min(two[0], two[1]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Dot(Vector256<double> x, Vector256<double> y, Vector256<double> z, Vector3D axis) =>
        (x * Vector256.Create(axis.X)) + (y * Vector256.Create(axis.Y)) + (z * Vector256.Create(axis.Z));
}
