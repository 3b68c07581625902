using Msisf.Core.Numerics;

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
    public RotationMatrix? FrameFromJ2000(double tdbSeconds)
    {
        double days = tdbSeconds / SecondsPerDay;
        double centuries = days / DaysPerCentury;
        double[] angles = [.. Angles.Select(angle => double.DegreesToRadians(PoleSeries.Polynomial(angle, centuries)))];
        double rightAscension = RightAscension.At(centuries, angles, Math.Sin);
        double declination = Declination.At(centuries, angles, Math.Cos);
        double meridian = Meridian.At(days, angles, Math.Sin);
        return EulerAngles.ToRotation(
            double.DegreesToRadians(90.0 + rightAscension), double.DegreesToRadians(90.0 - declination),
            double.DegreesToRadians(meridian));
    }
}
