using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// The orientation of a body by its pole and prime meridian, as the IAU's working group publishes them and text PCK kernels hold them.
/// Known at all times. Immutable.
/// </summary>
/// <remarks>
/// NAIF, PCK Required Reading, "Models for the Orientation": right ascension and declination are polynomials of T, the prime meridian is
/// one of d, each with a sum of periodic terms in the angles of the body's system, which are polynomials of T.
/// </remarks>
public sealed class PoleOrientation : IFrameOrientation
{
    private const double SecondsPerDay = 86_400.0;
    private const double DaysPerCentury = 36_525.0;

    /// <summary>Right ascension of the pole, degrees.</summary>
    public required PoleSeries RightAscension { get; init; }

    /// <summary>Declination of the pole, degrees; its periodic terms are cosines.</summary>
    public required PoleSeries Declination { get; init; }

    /// <summary>Prime meridian, degrees; its polynomial is one of days.</summary>
    public required PoleSeries Meridian { get; init; }

    /// <summary>Angles of the periodic terms: coefficients of 1, T, ... in degrees.</summary>
    public IReadOnlyList<IReadOnlyList<double>> Angles { get; init; } = [];

    /// <inheritdoc/>
    public TdbCover Cover => TdbCover.Everything;

    /// <inheritdoc/>
    public RotationMatrix? FrameFromJ2000(TdbTime time)
    {
        Vector3D angles = EulerAnglesAt(time);
        return EulerAngles.ToRotation(angles.X, angles.Y, angles.Z);
    }

    /// <inheritdoc/>
    public Vector3D? RateJ2000(TdbTime time)
    {
        double days = time.Seconds / SecondsPerDay;
        double centuries = days / DaysPerCentury;
        double[] angles = [.. Angles.Select(angle => double.DegreesToRadians(PoleSeries.Polynomial(angle, centuries)))];
        double[] perCentury = [.. Angles.Select(angle => double.DegreesToRadians(PoleSeries.Slope(angle, centuries)))];
        double[] perDay = [.. perCentury.Select(rate => rate / DaysPerCentury)];
        double rightAscension = RightAscension.RateAt(centuries, angles, perCentury, Math.Cos) / DaysPerCentury;
        double declination = Declination.RateAt(centuries, angles, perCentury, static angle => -Trigonometry.Sin(angle)) / DaysPerCentury;
        double meridian = Meridian.RateAt(days, angles, perDay, Math.Cos);
        return EulerAngles.ToRateJ2000(
            EulerAnglesAt(time),
            double.DegreesToRadians(1.0) / SecondsPerDay * new Vector3D(rightAscension, -declination, meridian));
    }

    /// <summary>The three angles of <see cref="EulerAngles"/>.</summary>
    private Vector3D EulerAnglesAt(TdbTime time)
    {
        double days = time.Seconds / SecondsPerDay;
        double centuries = days / DaysPerCentury;
        double[] angles = [.. Angles.Select(angle => double.DegreesToRadians(PoleSeries.Polynomial(angle, centuries)))];
        double rightAscension = RightAscension.At(centuries, angles, Math.Sin);
        double declination = Declination.At(centuries, angles, Math.Cos);
        double meridian = Meridian.At(days, angles, Math.Sin);
        return new Vector3D(
            double.DegreesToRadians(90.0 + rightAscension), double.DegreesToRadians(90.0 - declination),
            double.DegreesToRadians(meridian));
    }
}

/// <summary>The rotation of a body's frame by the three angles that kernels give.</summary>
internal static class EulerAngles
{
    /// <summary>The rotation that turns J2000 components into those of the frame.</summary>
    /// <param name="node">rad: from J2000's x axis to the body's ascending node on J2000's equator.</param>
    /// <param name="inclination">Inclination of the body's equator, rad.</param>
    /// <param name="meridian">rad: from the node to the prime meridian.</param>
    public static RotationMatrix ToRotation(double node, double inclination, double meridian) =>
        RotationMatrix.FrameAboutZ(Reduce(meridian)) * RotationMatrix.FrameAboutX(inclination) * RotationMatrix.FrameAboutZ(node);

    /// <summary>How fast the frame turns: rad/s relative to J2000, along J2000's axes.</summary>
    /// <param name="angles">rad: node, inclination, meridian.</param>
    /// <param name="rates">rad/s: their rates of change, each about its axis as the turns before it leave it.</param>
    public static Vector3D ToRateJ2000(Vector3D angles, Vector3D rates)
    {
        RotationMatrix afterNode = RotationMatrix.FrameAboutZ(angles.X);
        RotationMatrix afterInclination = RotationMatrix.FrameAboutX(angles.Y) * afterNode;
        return (rates.X * Vector3D.UnitZ) + (rates.Y * afterNode.Row0) + (rates.Z * afterInclination.Row2);
    }

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
