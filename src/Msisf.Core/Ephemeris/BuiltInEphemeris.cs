using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// The engine that needs no CSPICE: it chains the segments of the kernels itself. Safe for several threads, without locks.
/// </summary>
public sealed class BuiltInEphemeris : IEphemeris
{
    private const int Sun = 10;
    private const int Moon = 301;
    private const double MetresPerKilometre = 1000.0;

    /// <summary>
    /// Maximum number of links in a chain of centres, as in SPICE (CHLEN in SPKGEO); more links mean that the chain is a ring.
    /// </summary>
    private const int MaximumLinks = 20;

    private readonly TdbScale _scale;
    private readonly SegmentTable _positions;
    private readonly SegmentTable _orientations;
    private readonly BodyFixedFrame _moonMe;

    /// <summary>Makes the engine from what the kernels hold.</summary>
    /// <param name="scale">From the leap seconds kernel.</param>
    /// <param name="positions">Segments of the SPK kernels.</param>
    /// <param name="orientations">Segments of the binary PCK kernels.</param>
    /// <param name="moonMe">MOON_ME, from the frame kernels.</param>
    public BuiltInEphemeris(TdbScale scale, SegmentTable positions, SegmentTable orientations, BodyFixedFrame moonMe)
    {
        _scale = scale;
        _positions = positions;
        _orientations = orientations;
        _moonMe = moonMe;
    }

    /// <inheritdoc/>
    public string EngineName => "built-in kernel reader";

    /// <summary>Times at which the Sun, the Moon and the Moon's orientation are all known; computed anew at each call.</summary>
    public KernelCover Cover => new(
        _scale,
        _positions.CoverOfChain(Sun).Intersect(_positions.CoverOfChain(Moon)).Intersect(_orientations.CoverOf(_moonMe.OrientationBody)));

    /// <inheritdoc/>
    public Vector3D SunPositionMoonMe(ModifiedJulianDate time, Aberration aberration = Aberration.None)
    {
        double tdbSeconds = _scale.FromUtc(time);
        Vector3D sunKm = PositionKm(Sun, tdbSeconds) ?? throw Cover.Outside(time);
        Vector3D moonKm = PositionKm(Moon, tdbSeconds) ?? throw Cover.Outside(time);
        Vector3D sunFromMoonKm = sunKm - moonKm;
        if (aberration != Aberration.None)
        {
            // CSPICE's LT: one step only. More steps would move the Sun by 0.2 mm (tests/reference/sun_aberration.py).
            double lightSeconds = LightSpeed.TimeOver(sunFromMoonKm.Length);
            sunFromMoonKm = (PositionKm(Sun, tdbSeconds - lightSeconds) ?? throw Cover.LightFromOutside(time)) - moonKm;
        }

        if (!(sunFromMoonKm.Length is > 0.0 and < double.PositiveInfinity))
        {
            throw new BadInputException(
                $"The kernels put the Sun at {sunFromMoonKm} km from the Moon: they are damaged. Use other kernels.");
        }

        if (aberration == Aberration.LightTimeAndStellar)
        {
            sunFromMoonKm = LightSpeed.SeenFromMoving(sunFromMoonKm, MoonVelocity(tdbSeconds, time));
        }

        return MetresPerKilometre * (Rotation(tdbSeconds, time) * sunFromMoonKm);
    }

    /// <inheritdoc/>
    public RotationMatrix MoonMeFromJ2000(ModifiedJulianDate time) => Rotation(_scale.FromUtc(time), time);

    /// <summary>Position in km relative to the solar system's barycentre, J2000; null at a time that the kernels do not cover.</summary>
    private Vector3D? PositionKm(int body, double tdbSeconds) => SumOfChain(body, tdbSeconds, segment => segment.ValueAt(tdbSeconds));

    /// <summary>Velocity of the Moon in km/s relative to the solar system's barycentre, J2000.</summary>
    private Vector3D MoonVelocity(double tdbSeconds, ModifiedJulianDate time) =>
        SumOfChain(Moon, tdbSeconds, segment => segment.RateAt(tdbSeconds)) ?? throw Cover.Outside(time);

    private Vector3D? SumOfChain(int body, double tdbSeconds, Func<IEphemerisSegment, Vector3D> valueOf)
    {
        Vector3D sum = default;
        int link = body;
        for (int count = 0; link != SegmentTable.SolarSystemBarycenter; count++)
        {
            if (count == MaximumLinks)
            {
                throw new SpiceException(
                    $"The kernels' centres lead from body {body} nowhere: "
                        + $"{MaximumLinks} links did not reach the solar system's barycentre. Use other kernels.");
            }

            if (_positions.Find(link, tdbSeconds) is not IEphemerisSegment segment)
            {
                return null;
            }

            sum += valueOf(segment);
            link = segment.Center;
        }

        return sum;
    }

    private RotationMatrix Rotation(double tdbSeconds, ModifiedJulianDate time)
    {
        IEphemerisSegment segment = _orientations.Find(_moonMe.OrientationBody, tdbSeconds) ?? throw Cover.Outside(time);
        Vector3D angles = segment.ValueAt(tdbSeconds);
        RotationMatrix orientationFromJ2000 =
            RotationMatrix.FrameAboutZ(ReduceAngle(angles.Z)) * RotationMatrix.FrameAboutX(angles.Y) * RotationMatrix.FrameAboutZ(angles.X);
        return _moonMe.FrameFromOrientation * orientationFromJ2000;
    }

    /// <summary>
    /// Subtracts whole turns of the double nearest to 2 pi, as CSPICE does (DMOD in PCKMAT, as f2c writes it). Sine and cosine do not
    /// need it, but without it the engines differ by 7e-13, about one unit in the angle's last place.
    /// </summary>
    private static double ReduceAngle(double angle)
    {
        const double Turn = 2.0 * Math.PI;
        return angle - (Turn * Math.Truncate(angle / Turn));
    }
}
