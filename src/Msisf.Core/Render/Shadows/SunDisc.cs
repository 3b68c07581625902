using System.Numerics;
using Msisf.Core.Ephemeris;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The Sun's disc as 64 points that stand for equal parts of its area; the disc is assumed to be equally bright everywhere. The points
/// lie in four rings of 4, 12, 20 and 28 points, and their mean is the disc's centre.
/// </summary>
/// <remarks>
/// For a disc cut by a straight edge, the error of the visible fraction is at most 0.046, and its root mean square over all edges is at
/// most 0.012 (tests/reference/sun_disc.py).
/// </remarks>
internal sealed class SunDisc
{
    /// <summary>Number of points of the disc, and of bits in a mask of them.</summary>
    public const int Points = 64;

    /// <summary>Number of consecutive points in an eighth of the disc; the points are sorted by their angle around the centre.</summary>
    public const int PointsPerSector = 8;

    /// <summary>Mask of all points.</summary>
    public const ulong All = ulong.MaxValue;

    private static readonly int[] Rings = [4, 12, 20, 28];

    /// <summary>
    /// Rotation of each ring as a fraction of the angle between two of its points: the multiples of 0.25 with the smallest maximum error.
    /// </summary>
    private static readonly double[] Turns = [0.5, 0.75, 0.0, 0.75];

    private readonly Vector3D[] _pointsBodyFixed;

    /// <summary>Places the points for a position of the Sun.</summary>
    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    /// <param name="sunRadius">Radius of the Sun, or of another light that is a disc, m.</param>
    /// <exception cref="BadInputException">The Moon's centre is inside the Sun.</exception>
    public SunDisc(Vector3D sunBodyFixed, double sunRadius = AstronomicalConstants.SunRadius)
    {
        CentreBodyFixed = sunBodyFixed;
        double distance = sunBodyFixed.Length;
        if (!(distance > sunRadius))
        {
            throw new BadInputException(
                $"The Sun is at {sunBodyFixed} m, so that the Moon is inside the Sun; give a position farther away.");
        }

        // The angular radius of a sphere's outline is asin(R / D); a disc at the distance of its centre has this radius.
        double radius = distance * sunRadius / Math.Sqrt((distance - sunRadius) * (distance + sunRadius));
        Slope = radius / distance;
        LightFrame axes = new(sunBodyFixed, Vector3D.UnitZ);
        List<(double Turn, double FromCentre)> points = [];
        foreach ((int count, double offset) in Rings.Zip(Turns))
        {
            double part = (points.Count + (0.5 * count)) / Points; // of the area within the ring's middle
            points.AddRange(Enumerable.Range(0, count).Select(i => ((i + offset) / count, radius * Math.Sqrt(part))));
        }

        _pointsBodyFixed = [.. points.OrderBy(point => point.Turn).Select(point =>
        {
            (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * point.Turn);
            return sunBodyFixed + (point.FromCentre * ((cosine * axes.AxisU) + (sine * axes.AxisV)));
        })];
    }

    /// <summary>The centre of the disc, m, body-fixed.</summary>
    public Vector3D CentreBodyFixed { get; }

    /// <summary>The disc's radius over its distance from the Moon's centre: the tangent of its angular radius there.</summary>
    public double Slope { get; }

    /// <summary>The points, m, body-fixed; the first one belongs to the lowest bit of a mask.</summary>
    public ReadOnlySpan<Vector3D> PointsBodyFixed => _pointsBodyFixed;

    /// <summary>The light of the disc on a point of a facet.</summary>
    /// <param name="pointBodyFixed">The point, m, body-fixed.</param>
    /// <param name="normalBodyFixed">Outward normal, body-fixed, length 1.</param>
    /// <param name="hidden">Mask of the points of the disc that terrain hides (<see cref="PenumbraPass"/>).</param>
    public DiscLight LightAt(Vector3D pointBodyFixed, Vector3D normalBodyFixed, ulong hidden)
    {
        int visible = 0;
        double sum = 0.0;
        for (ulong left = ~hidden; left != 0; left &= left - 1)
        {
            Vector3D toSun = _pointsBodyFixed[BitOperations.TrailingZeroCount(left)] - pointBodyFixed;
            double cosine = Vector3D.Dot(normalBodyFixed, toSun) / Math.Sqrt(toSun.LengthSquared); // 1e11 m: its square does not overflow
            if (cosine > 0.0)
            {
                visible++;
                sum += cosine;
            }
        }

        return new DiscLight((double)visible / Points, sum / Points);
    }

    /// <summary>Whether the plane of a facet may cut the disc, seen from a point of the facet.</summary>
    /// <param name="cosIncidence">Cosine of the angle between the facet's normal and the direction to the disc's centre.</param>
    public bool IsCut(double cosIncidence) => Math.Abs(cosIncidence) <= -MinCosine;

    /// <summary>Whether a part of the disc may be above the plane of a facet, seen from a point of the facet.</summary>
    /// <param name="cosIncidence">Cosine of the angle between the facet's normal and the direction to the disc's centre.</param>
    public bool MayLight(double cosIncidence) => cosIncidence > MinCosine;

    /// <summary>Cosine of the incidence angle, to the disc's centre, below which no part of the disc is above a facet's plane.</summary>
    public double MinCosine => -1.01 * Slope; // seen from the near side of the Moon the disc is 1.2e-5 parts wider
}

/// <summary>The light of the Sun's disc on a point of a facet; <c>default</c> is not a light.</summary>
/// <param name="VisibleFraction">Fraction of the disc's area that neither terrain nor the facet's own plane hides, 0 to 1.</param>
/// <param name="Irradiance">Mean over the whole disc of the cosine of the incidence angle; hidden parts count as 0.</param>
internal readonly record struct DiscLight(double VisibleFraction, double Irradiance);
