using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Core.Sky;

/// <summary>
/// How the sky lies about the drawn body at one time, as an observer there sees it: along the axes in which the frame is drawn, so that
/// stars and ground are to each other as in a real image. Immutable.
/// </summary>
/// <remarks>
/// What finite light does to the ground decides what it does to stars. Without it, the ground lies where it is; a real camera would see it
/// displaced by its own velocity relative to the ground, so that stars are aberrated by the velocity of the body alone, which is exact to
/// that relative velocity over the speed of light. With light time the ground lies where a camera at rest would see it, and stars are not
/// aberrated. With stellar aberration too, stars are aberrated by the velocity of the camera, and are drawn as the real camera has them,
/// whose attitude the drawn one is turned from (<see cref="GroundAberration"/>).
/// </remarks>
public sealed record SkyAxes
{
    private const double MetresPerKilometre = 1000.0;

    /// <summary>Radius of the Earth over its distance from which on it matters that its near parts are nearer.</summary>
    private const double LeastNearness = 1e-4;

    /// <summary>Solutions of the light time: each makes the error 1e-4 times as large.</summary>
    private const int LightSteps = 4;

    /// <summary>Solutions of the drawn turn for the real one: each makes the error 1e-4 times as large.</summary>
    private const int TurnSteps = 4;

    private readonly RotationMatrix _bodyFromJ2000;
    private readonly Vector3D _rateBodyFixed;
    private readonly Vector3D _velocityInC;
    private readonly Vector3D _observerAu;
    private readonly bool _isTurned;
    private readonly Vector3D _cameraJ2000; // m, from the drawn body's centre

    private SkyAxes(
        RotationMatrix bodyFromJ2000, Vector3D rateBodyFixed, Vector3D velocityInC, Vector3D observerAu, double yearsPastJ2000,
        bool isTurned, Vector3D cameraJ2000) =>
        (_bodyFromJ2000, _rateBodyFixed, _velocityInC, _observerAu, YearsPastJ2000, _isTurned, _cameraJ2000) =
        (bodyFromJ2000, rateBodyFixed, velocityInC, observerAu, yearsPastJ2000, isTurned, cameraJ2000);

    /// <summary>The sky about a camera.</summary>
    /// <param name="frameTime">The image's time.</param>
    /// <param name="state">The camera as it is drawn, with its seconds after that.</param>
    /// <param name="observer">What finite light does to its ground, and its velocity; null for nothing.</param>
    /// <param name="radius">Radius of the sphere that stands for the ground, m.</param>
    /// <param name="bodies">Bodies whose places are to be known; null for none.</param>
    /// <exception cref="MsisfException">The time is outside the kernels' cover, or they have no such body.</exception>
    public static SkyAxes At(
        Instant frameTime, in CameraState state, SkyObserver? observer, IEphemeris ephemeris, double radius,
        IReadOnlyList<SkyBody>? bodies = null)
    {
        Instant time = frameTime.After(state.Seconds);
        TdbTime tdb = time.Tdb;
        Aberration ofGround = observer?.OfGround ?? Aberration.None;
        StateVector barycenter = ephemeris.StateOf(SegmentTable.SolarSystemBarycenter, tdb);
        double lightSeconds = ofGround == Aberration.None ? 0.0 : GroundAberration.LightSeconds(state, radius);
        TdbTime ofBody = tdb + -lightSeconds;
        RotationMatrix axes = ephemeris.BodyFromJ2000(ofBody);
        Vector3D velocity = ofGround switch
        {
            Aberration.None => -barycenter.Velocity,
            Aberration.LightTime => default,
            _ => observer!.VelocityJ2000(time) - barycenter.Velocity,
        };
        Vector3D camera = axes.Transposed * state.PositionBodyFixed;
        Vector3D inC = velocity / (MetresPerKilometre * LightSpeed.KilometresPerSecond);
        return new SkyAxes(
            axes,
            axes * ephemeris.BodyRateJ2000(ofBody),
            inC,
            -barycenter.Position / AstronomicalConstants.AstronomicalUnit,
            tdb.Seconds / AstronomicalConstants.JulianYear,
            ofGround == Aberration.LightTimeAndStellar,
            camera)
        {
            Seconds = state.Seconds,
            Bodies = [.. (bodies ?? []).Select(body => PlaceOf(body, tdb, camera - barycenter.Position, inC, ephemeris))],
        };
    }

    /// <summary>Julian years after J2000, TDB.</summary>
    public double YearsPastJ2000 { get; }

    /// <summary>s after the image's time.</summary>
    public double Seconds { get; private init; }

    /// <summary>Where the bodies are that were asked for.</summary>
    public IReadOnlyList<BodyPlace> Bodies { get; private init; } = [];

    /// <summary>rad/s: how fast the body turns.</summary>
    public double BodyRate => _rateBodyFixed.Length;

    /// <summary>Turns body-fixed axes into those of J2000.</summary>
    public RotationMatrix J2000FromBody => _bodyFromJ2000.Transposed;

    /// <summary>The direction in which the observer sees a star.</summary>
    /// <returns>Length 1, J2000.</returns>
    public Vector3D ApparentJ2000(in Star star) =>
        StellarAberration.Of(star.DirectionFrom(YearsPastJ2000, _observerAu), _velocityInC);

    /// <summary>The direction along which a camera that is drawn has what a real camera sees in a direction.</summary>
    /// <param name="apparentJ2000">From <see cref="ApparentJ2000"/>.</param>
    /// <param name="moonFromCamera">Orientation of the camera as it is drawn at that time.</param>
    /// <param name="seconds">s after the image's time, some minutes from that of these axes: the body turns at a constant rate.</param>
    /// <returns>Length 1, body-fixed.</returns>
    public Vector3D DrawnDirection(Vector3D apparentJ2000, UnitQuaternion moonFromCamera, double seconds)
    {
        Vector3D bodyFixed = TurnedBack(_bodyFromJ2000 * apparentJ2000, seconds);
        if (!_isTurned)
        {
            return bodyFixed;
        }

        Vector3D velocity = TurnedBack(_bodyFromJ2000 * _velocityInC, seconds);
        Vector3D drawn = moonFromCamera * -Vector3D.UnitX;
        Vector3D real = drawn;
        for (int step = 0; step < TurnSteps; step++)
        {
            real = GroundAberration.Turn(real, velocity).Conjugate * drawn;
        }

        return GroundAberration.Turn(real, velocity) * bodyFixed;
    }

    /// <summary>A body as the camera sees it some time later, from where it is by then: both fly on straight lines.</summary>
    /// <param name="place">From <see cref="Bodies"/>.</param>
    /// <param name="positionBodyFixed">Position of the camera by then, m.</param>
    /// <param name="seconds">s after the image's time.</param>
    public BodyPlace Seen(BodyPlace place, Vector3D positionBodyFixed, double seconds)
    {
        Vector3D camera = J2000FromBody * Turned(positionBodyFixed, seconds - Seconds);
        Vector3D way = place.WayJ2000 + ((seconds - Seconds) * place.VelocityJ2000) - (camera - _cameraJ2000);
        return place with
        {
            ApparentJ2000 = StellarAberration.Of(way.Normalized(), _velocityInC),
            WayJ2000 = way,
            Distance = way.Length,
        };
    }

    /// <summary>The nearest of <see cref="Bodies"/> whose disc, lit or not, lies in a direction; null for none.</summary>
    /// <param name="drawn">Length 1, body-fixed.</param>
    /// <param name="camera">The camera as it is drawn at that time.</param>
    /// <param name="seconds">s after the image's time.</param>
    internal SkyBody? BodyIn(Vector3D drawn, FrameCamera camera, double seconds)
    {
        BodyPlace? nearest = null;
        foreach (BodyPlace body in Bodies)
        {
            BodyPlace place = Seen(body, camera.PositionBodyFixed, seconds);
            Vector3D centre = Drawn(place.ApparentJ2000);
            if (Vector3D.Dot(drawn, centre) >= Trigonometry.Cos(place.AngularRadius) && !(nearest?.Distance <= place.Distance)
                && new BodyDisc(place, centre, Drawn).Covers(drawn))
            {
                nearest = place;
            }
        }

        return nearest?.Body;

        Vector3D Drawn(Vector3D inJ2000) => DrawnDirection(inJ2000, camera.MoonFromCamera, seconds);
    }

    /// <summary>Where an observer sees a body.</summary>
    /// <param name="observer">m, from the solar system's barycentre, J2000.</param>
    private static BodyPlace PlaceOf(SkyBody body, TdbTime time, Vector3D observer, Vector3D velocityInC, IEphemeris ephemeris)
    {
        double seconds = 0.0;
        Vector3D way = default;
        for (int step = 0; step < LightSteps; step++)
        {
            way = FromBarycenter(body.NaifNumber, time + -seconds) - observer;
            seconds = LightSpeed.TimeOver(way.Length / MetresPerKilometre);
        }

        TdbTime sent = time + -seconds;
        Vector3D sun = FromBarycenter(SkyBody.Sun.NaifNumber, sent) - FromBarycenter(body.NaifNumber, sent);
        bool isSun = body == SkyBody.Sun;
        double distance = way.Length / AstronomicalConstants.AstronomicalUnit;
        double phase = isSun ? 0.0 : Vector3D.AngleBetween(sun, -way);
        double magnitude = isSun
            ? PlanetMagnitude.OfSun + (5.0 * Math.Log10(distance))
            : PlanetMagnitude.Of(
                body.NaifNumber, sun.Length / AstronomicalConstants.AstronomicalUnit, distance, double.RadiansToDegrees(phase),
                Latitude(sun), Latitude(-way), time.Seconds / AstronomicalConstants.JulianYear);
        double ratio = body.EquatorialRadius / way.Length;
        if (body == SkyBody.Earth && ratio is > LeastNearness and < 1.0)
        {
            magnitude -= 2.5 * Math.Log10(LambertSphere.Of(phase, ratio).Light);
        }

        return new BodyPlace(
            body, StellarAberration.Of(way.Normalized(), velocityInC), way.Length, isSun ? default : sun.Normalized(), phase, magnitude)
        {
            WayJ2000 = way,
            VelocityJ2000 = ephemeris.StateOf(body.NaifNumber, time).Velocity,
        };

        Vector3D FromBarycenter(int number, TdbTime at) =>
            ephemeris.StateOf(number, at).Position - ephemeris.StateOf(SegmentTable.SolarSystemBarycenter, at).Position;

        double Latitude(Vector3D direction) => 90.0 - double.RadiansToDegrees(Vector3D.AngleBetween(body.PoleJ2000, direction));
    }

    /// <summary>A direction as the body has it, which has turned since.</summary>
    private Vector3D TurnedBack(Vector3D bodyFixed, double seconds) => Turned(bodyFixed, Seconds - seconds);

    /// <summary>What the body's turn makes of a vector in some time.</summary>
    private Vector3D Turned(Vector3D bodyFixed, double span)
    {
        double angle = _rateBodyFixed.Length * span;
        return angle == 0.0 ? bodyFixed : UnitQuaternion.FromAxisAngle(_rateBodyFixed, angle) * bodyFixed;
    }
}
