using Msisf.Core.Numerics;

namespace Msisf.Core.Ephemeris;

/// <summary>The rotation of a body's frame by the three angles that kernels give.</summary>
internal static class EulerAngles
{
    /// <summary>The rotation that turns J2000 components into those of the frame.</summary>
    /// <param name="node">rad: from J2000's x axis to the body's ascending node on J2000's equator.</param>
    /// <param name="inclination">rad: of the body's equator.</param>
    /// <param name="meridian">rad: from the node to the prime meridian.</param>
    public static RotationMatrix ToRotation(double node, double inclination, double meridian) =>
        RotationMatrix.FrameAboutZ(Reduce(meridian)) * RotationMatrix.FrameAboutX(inclination) * RotationMatrix.FrameAboutZ(node);

    /// <summary>
    /// Subtracts whole turns of the double nearest to 2 pi, as CSPICE does (DMOD in PCKMAT, as f2c writes it). Sine and cosine do not
    /// need it, but without it the engines differ by 7e-13, about one unit in the angle's last place.
    /// </summary>
    private static double Reduce(double angle)
    {
        const double Turn = 2.0 * Math.PI;
        return angle - (Turn * Math.Truncate(angle / Turn));
    }
}
