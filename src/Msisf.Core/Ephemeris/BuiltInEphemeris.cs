using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>
/// The engine that needs no CSPICE: it chains the segments of the kernels itself. Safe for several threads, without locks.
/// </summary>
/// <param name="scale">From the leap seconds kernel.</param>
/// <param name="orientation">Orientation of the body's frame: for the Moon that of MOON_ME.</param>
/// <param name="body">The body; null for the Moon.</param>
public sealed class BuiltInEphemeris(
    TimeScale scale, SegmentTable positions, IFrameOrientation orientation, CelestialBody? body = null) : IEphemeris
{
    private const int Sun = 10;
    private const double MetresPerKilometre = 1000.0;

    private readonly CenterChain _chain = new(positions);
    private readonly CelestialBody _body = body ?? CelestialBody.Moon;

    /// <inheritdoc/>
    public string EngineName => "built-in kernel reader";

    /// <inheritdoc/>
    public TimeScale TimeScale => scale;

    /// <summary>Times at which the Sun, the body and the body's orientation are all known; computed anew at each call.</summary>
    public KernelCover Cover => new(
        scale, positions.CoverOfChain(Sun).Intersect(positions.CoverOfChain(_body.NaifNumber)).Intersect(orientation.Cover))
    {
        Body = _body,
    };

    /// <inheritdoc/>
    public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None)
    {
        TdbTime tdb = time.Tdb;
        Vector3D sunKm = PositionKm(Sun, tdb) ?? throw Cover.Outside(time);
        Vector3D bodyKm = PositionKm(_body.NaifNumber, tdb) ?? throw Cover.Outside(time);
        Vector3D sunFromBodyKm = sunKm - bodyKm;
        if (aberration != Aberration.None)
        {
            // CSPICE's LT: one step only. More steps would move the Sun by 0.2 mm (tests/reference/sun_aberration.py).
            double lightSeconds = LightSpeed.TimeOver(sunFromBodyKm.Length);
            sunFromBodyKm = (PositionKm(Sun, tdb + -lightSeconds) ?? throw Cover.LightFromOutside(time)) - bodyKm;
        }

        if (!(sunFromBodyKm.Length is > 0.0 and < double.PositiveInfinity))
        {
            throw new BadInputException(
                $"The kernels put the Sun at {sunFromBodyKm} km from {_body.NameInText}: they are damaged. Use other kernels.");
        }

        if (aberration == Aberration.LightTimeAndStellar)
        {
            sunFromBodyKm = LightSpeed.SeenFromMoving(sunFromBodyKm, BodyVelocity(tdb, time));
        }

        return MetresPerKilometre * ((orientation.FrameFromJ2000(tdb) ?? throw Cover.Outside(time)) * sunFromBodyKm);
    }

    /// <inheritdoc/>
    public RotationMatrix BodyFromJ2000(TdbTime time) =>
        orientation.FrameFromJ2000(time) ?? throw Cover.Outside(scale.InstantOf(time));

    /// <inheritdoc/>
    public Vector3D BodyRateJ2000(TdbTime time) => orientation.RateJ2000(time) ?? throw Cover.Outside(scale.InstantOf(time));

    /// <inheritdoc/>
    public StateVector StateOf(int naifNumber, TdbTime time)
    {
        StateVector state = MetresPerKilometre
            * (_chain.StateKm(naifNumber, _body.NaifNumber, time) ?? throw NoState(naifNumber, time));
        return state.Position.IsFinite && state.Velocity.IsFinite
            ? state
            : throw new BadInputException(Invariant(
                $"The kernels put body {naifNumber} out of all bounds at {scale.InstantOf(time).ToIsoUtc()}: they are damaged. "
                    + $"Use other kernels."));
    }

    private SpiceException NoState(int body, TdbTime time)
    {
        TdbCover cover = positions.CoverOfChain(body);
        string has = cover.Intervals.Count == 0
            ? "nothing of that body. Use kernels that have it"
            : $"{new KernelCover(scale, cover).Describe()}. Choose a time inside, or other kernels";
        return new SpiceException(
            $"No kernel leads from body {body} to {_body.NameInText} at {scale.InstantOf(time).ToIsoUtc()}: the kernels have {has}.");
    }

    /// <summary>Position in km relative to the solar system's barycentre, J2000; null at a time that the kernels do not cover.</summary>
    private Vector3D? PositionKm(int body, TdbTime time) => SumOfChain(body, time, segment => segment.ValueAt(time));

    /// <summary>Velocity of the body in km/s relative to the solar system's barycentre, J2000.</summary>
    private Vector3D BodyVelocity(TdbTime tdb, Instant time) =>
        SumOfChain(_body.NaifNumber, tdb, segment => segment.RateAt(tdb)) ?? throw Cover.Outside(time);

    private Vector3D? SumOfChain(int body, TdbTime time, Func<IEphemerisSegment, Vector3D> valueOf)
    {
        Vector3D sum = default;
        int link = body;
        for (int count = 0; link != SegmentTable.SolarSystemBarycenter; count++)
        {
            if (count == CenterChain.MaximumLinks)
            {
                throw new SpiceException(
                    $"The kernels' centres lead from body {body} nowhere: "
                        + $"{CenterChain.MaximumLinks} links did not reach the solar system's barycentre. Use other kernels.");
            }

            if (positions.Find(link, time) is not IEphemerisSegment segment)
            {
                return null;
            }

            sum += valueOf(segment);
            link = segment.Center;
        }

        return sum;
    }
}

/// <summary>
/// Follows the centres of segments from one body to another, as SPICE does: to the first centre that both have in common, so that nothing
/// is lost by sums over the distance to the Sun. Safe for several threads.
/// </summary>
internal sealed class CenterChain(SegmentTable segments)
{
    /// <summary>
    /// Maximum number of links in a chain of centres, as in SPICE (CHLEN in SPKGEO); more links mean that the chain is a ring.
    /// </summary>
    public const int MaximumLinks = 20;

    /// <summary>State of a body relative to another one, J2000; null if no kernel leads from one to the other at that time.</summary>
    /// <param name="target">NAIF's number.</param>
    /// <param name="observer">NAIF's number.</param>
    /// <returns>km, km/s.</returns>
    /// <exception cref="SpiceException">The chain of centres is a ring, or a segment can't be read.</exception>
    public StateVector? StateKm(int target, int observer, TdbTime time)
    {
        List<(int Body, StateVector FromTarget)> chain = [(target, default)];
        while (chain[^1].Body != observer && Next(chain[^1], target, chain.Count, time) is { } link)
        {
            chain.Add(link);
        }

        (int Body, StateVector FromTarget) end = (observer, default);
        for (int count = 1; ; count++)
        {
            int common = chain.FindIndex(link => link.Body == end.Body);
            if (common >= 0)
            {
                return end.FromTarget - chain[common].FromTarget;
            }

            if (Next(end, observer, count, time) is not { } link)
            {
                return null;
            }

            end = link;
        }
    }

    /// <summary>The next centre, with its state relative to the chain's first body, negative; null where the chain ends.</summary>
    private (int Body, StateVector FromTarget)? Next(
        (int Body, StateVector FromTarget) link, int first, int count, TdbTime time)
    {
        if (link.Body == SegmentTable.SolarSystemBarycenter || segments.Find(link.Body, time) is not { } segment)
        {
            return null;
        }

        return count <= MaximumLinks
            ? (segment.Center, link.FromTarget - segment.StateAt(time))
            : throw new SpiceException(Invariant(
                $"The kernels' centres lead from body {first} nowhere: {MaximumLinks} links end at none that is known. "
                    + $"Use other kernels."));
    }
}
