using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Camera;

/// <summary>How far a hit point may be from the true one: the limits of the stress tests, as formulas.</summary>
/// <remarks>
/// A ray is a point and a direction in doubles. Turning the direction by a rounding (2^-53 rad) moves the ray across itself by 2^-53 of the
/// camera's distance at the Moon, which is also what rounding the camera's own position does: the inputs carry no more. Along the
/// ray a surface met at a slant makes more of it, by the cosine of the angle to its normal.
/// </remarks>
internal static class HitBounds
{
    /// <summary>
    /// Roundings of the inputs that a ray's place at the Moon may be off; nearer to a tangent it may hit or miss. Those of the direction,
    /// and four of its length and of the products that give its nearest approach to the Moon's centre.
    /// </summary>
    public const double Roundings = RayMeasure.DirectionLimit + 4.0;

    /// <summary>m: the range that figures in plain metres or degrees are for; the far side of any orbit of the Moon.</summary>
    public const double OrbitDistance = 1e7;

    /// <summary>1: cosine of the angle to the surface's normal down to which these figures are; 84 degrees.</summary>
    public const double PlainCosine = 0.1;

    /// <summary>m: a hit point's, from <see cref="OrbitDistance"/>, at such angles.</summary>
    public const double PlainLimit = 1e-7;

    /// <summary>m: what one rounding of the inputs moves a ray across itself at the Moon.</summary>
    /// <param name="camera">m, MOON_ME.</param>
    public static double Carried(Vector3D camera) => RayMeasure.Rounding * (camera.Length + MoonConstants.ReferenceRadius);

    /// <summary>
    /// m: on the reference sphere. Along the ray from half chord h to sqrt(h^2 + 2 R d) when it comes d nearer to the centre.
    /// </summary>
    /// <param name="camera">m, MOON_ME.</param>
    /// <param name="cosEmission">Of the angle between line of sight and zenith.</param>
    public static double OnSphere(Vector3D camera, double cosEmission)
    {
        double across = Roundings * Carried(camera);
        double halfChord = MoonConstants.ReferenceRadius * cosEmission;
        double change = 2.0 * MoonConstants.ReferenceRadius * across;
        return across + (change / (halfChord + Math.Sqrt((halfChord * halfChord) + change)));
    }

    /// <summary>m: on a facet.</summary>
    /// <param name="camera">m, MOON_ME.</param>
    /// <param name="cosine">Of the angle between line of sight and the facet's normal.</param>
    public static double OnFacet(Vector3D camera, double cosine) => Roundings * Carried(camera) / cosine;
}
