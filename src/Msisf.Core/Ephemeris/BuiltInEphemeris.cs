using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// The engine that needs no CSPICE: it chains the segments of the kernels itself. Safe for several threads, without locks.
/// </summary>
public sealed class BuiltInEphemeris : IEphemeris
{
    private const int Sun = 10;
    private const double MetresPerKilometre = 1000.0;

    /// <summary>
    /// Maximum number of links in a chain of centres, as in SPICE (CHLEN in SPKGEO); more links mean that the chain is a ring.
    /// </summary>
    private const int MaximumLinks = 20;

    private readonly TdbScale _scale;
    private readonly SegmentTable _positions;
    private readonly CenterChain _chain;
    private readonly IFrameOrientation _orientation;
    private readonly CelestialBody _body;

    /// <summary>Makes the engine from what the kernels hold.</summary>
    /// <param name="scale">From the leap seconds kernel.</param>
    /// <param name="positions">Segments of the SPK kernels.</param>
    /// <param name="orientation">Orientation of the body's frame: for the Moon that of MOON_ME.</param>
    /// <param name="body">The body; null for the Moon.</param>
    public BuiltInEphemeris(TdbScale scale, SegmentTable positions, IFrameOrientation orientation, CelestialBody? body = null)
    {
        _scale = scale;
        _positions = positions;
        _chain = new CenterChain(positions);
        _orientation = orientation;
        _body = body ?? CelestialBody.Moon;
    }

    /// <inheritdoc/>
    public string EngineName => "built-in kernel reader";

    /// <inheritdoc/>
    public TdbScale TimeScale => _scale;

    /// <summary>Times at which the Sun, the body and the body's orientation are all known; computed anew at each call.</summary>
    public KernelCover Cover => new(
        _scale, _positions.CoverOfChain(Sun).Intersect(_positions.CoverOfChain(_body.NaifNumber)).Intersect(_orientation.Cover))
    {
        Body = _body,
    };

    /// <inheritdoc/>
    public Vector3D SunPositionBodyFixed(ModifiedJulianDate time, Aberration aberration = Aberration.None)
    {
        double tdbSeconds = _scale.FromUtc(time);
        Vector3D sunKm = PositionKm(Sun, tdbSeconds) ?? throw Cover.Outside(time);
        Vector3D bodyKm = PositionKm(_body.NaifNumber, tdbSeconds) ?? throw Cover.Outside(time);
        Vector3D sunFromBodyKm = sunKm - bodyKm;
        if (aberration != Aberration.None)
        {
            // CSPICE's LT: one step only. More steps would move the Sun by 0.2 mm (tests/reference/sun_aberration.py).
            double lightSeconds = LightSpeed.TimeOver(sunFromBodyKm.Length);
            sunFromBodyKm = (PositionKm(Sun, tdbSeconds - lightSeconds) ?? throw Cover.LightFromOutside(time)) - bodyKm;
        }

        if (!(sunFromBodyKm.Length is > 0.0 and < double.PositiveInfinity))
        {
            throw new BadInputException(
                $"The kernels put the Sun at {sunFromBodyKm} km from {_body.NameInText}: they are damaged. Use other kernels.");
        }

        if (aberration == Aberration.LightTimeAndStellar)
        {
            sunFromBodyKm = LightSpeed.SeenFromMoving(sunFromBodyKm, BodyVelocity(tdbSeconds, time));
        }

        return MetresPerKilometre * (Rotation(tdbSeconds, time) * sunFromBodyKm);
    }

    /// <inheritdoc/>
    public RotationMatrix MoonMeFromJ2000(ModifiedJulianDate time) => Rotation(_scale.FromUtc(time), time);

    /// <inheritdoc/>
    public RotationMatrix MoonMeFromJ2000(double tdbSeconds) =>
        _orientation.FrameFromJ2000(tdbSeconds) ?? throw Cover.Outside(_scale.ToUtc(tdbSeconds));

    /// <inheritdoc/>
    public StateVector StateOf(int naifNumber, double tdbSeconds)
    {
        StateVector state = MetresPerKilometre
            * (_chain.StateKm(naifNumber, _body.NaifNumber, tdbSeconds) ?? throw NoState(naifNumber, tdbSeconds));
        return state.Position.IsFinite && state.Velocity.IsFinite
            ? state
            : throw new BadInputException(Invariant(
                $"The kernels put body {naifNumber} out of all bounds at {_scale.ToUtc(tdbSeconds).ToIsoUtc()}: they are damaged. "
                    + $"Use other kernels."));
    }

    private SpiceException NoState(int body, double tdbSeconds)
    {
        TdbCover cover = _positions.CoverOfChain(body);
        return new SpiceException(Invariant(
            $"No kernel leads from body {body} to {_body.NameInText} at {_scale.ToUtc(tdbSeconds).ToIsoUtc()}: the kernels have "
                + $"{(cover.Intervals.Count == 0 ? "nothing of that body" : new KernelCover(_scale, cover).Describe())}. "
                + $"Choose a time inside, or other kernels."));
    }

    /// <summary>Position in km relative to the solar system's barycentre, J2000; null at a time that the kernels do not cover.</summary>
    private Vector3D? PositionKm(int body, double tdbSeconds) => SumOfChain(body, tdbSeconds, segment => segment.ValueAt(tdbSeconds));

    /// <summary>Velocity of the body in km/s relative to the solar system's barycentre, J2000.</summary>
    private Vector3D BodyVelocity(double tdbSeconds, ModifiedJulianDate time) =>
        SumOfChain(_body.NaifNumber, tdbSeconds, segment => segment.RateAt(tdbSeconds)) ?? throw Cover.Outside(time);

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

    private RotationMatrix Rotation(double tdbSeconds, ModifiedJulianDate time) =>
        _orientation.FrameFromJ2000(tdbSeconds) ?? throw Cover.Outside(time);
}
