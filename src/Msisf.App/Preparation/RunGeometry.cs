using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Terrain and Sun of a run, each opened only where a camera is placed or pointed by it.</summary>
/// <param name="model">Opens the elevation model, or returns the open one.</param>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="scale">Reads the leap seconds, or returns those that were read.</param>
/// <param name="aberration">Which effects of light's finite speed the Sun's position includes, as for the run's light.</param>
/// <param name="body">The body; null for the Moon.</param>
internal sealed class RunGeometry(
    Func<ElevationModel> model, Func<IEphemeris> ephemeris, Func<TimeScale> scale, Aberration aberration, CelestialBody? body = null)
    : ISceneGeometry
{
    public CelestialBody Body { get; } = body ?? CelestialBody.Moon;

    public double ReferenceRadius => Body.IsMoon ? MoonConstants.ReferenceRadius : model().Grid.ReferenceRadius;

    public TimeScale TimeScale => scale();

    public double GroundRadius(Vector3D directionBodyFixed) => model().GroundRadius(directionBodyFixed);

    public Vector3D SunPositionBodyFixed(Instant time) => ephemeris().SunPositionBodyFixed(time, aberration);

    public RotationMatrix BodyFromJ2000(Instant time) => ephemeris().BodyFromJ2000(time.Tdb);
}

/// <summary>Where the Sun is at the times of images. Not for several threads, as CSPICE is not.</summary>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="aberration">Which effects of light's finite speed are included.</param>
/// <param name="shared">Keeps what several cameras ask for; null where one does.</param>
internal sealed class SunPositions(Func<IEphemeris> ephemeris, Aberration aberration, SharedReadings? shared = null)
{
    /// <summary>m, body-fixed.</summary>
    public Vector3D At(Instant time)
    {
        IEphemeris engine = ephemeris();
        return shared?.SunAt(time, aberration, engine) ?? engine.SunPositionBodyFixed(time, aberration);
    }
}

/// <summary>What the cameras of one request share: the states that were read, and where the Sun is. Not for several threads.</summary>
internal sealed class SharedReadings
{
    private readonly Dictionary<(Instant Time, Aberration Aberration, IEphemeris Engine), Vector3D> _suns = [];
    private readonly Dictionary<StatesKey, IReadOnlyList<SpacecraftState>> _states = [];

    /// <summary>m, body-fixed.</summary>
    public Vector3D SunAt(Instant time, Aberration aberration, IEphemeris engine)
    {
        if (!_suns.TryGetValue((time, aberration, engine), out Vector3D position))
        {
            _suns.Add((time, aberration, engine), position = engine.SunPositionBodyFixed(time, aberration));
        }

        return position;
    }

    /// <summary>The states as they are read, before a camera makes its own of them.</summary>
    /// <param name="key">What they depend on.</param>
    /// <param name="read">Reads them.</param>
    public IReadOnlyList<SpacecraftState> States(StatesKey key, Func<IReadOnlyList<SpacecraftState>> read)
    {
        if (!_states.TryGetValue(key, out IReadOnlyList<SpacecraftState>? states))
        {
            _states.Add(key, states = read());
        }

        return states;
    }
}

/// <summary>What the states of a request depend on.</summary>
/// <param name="Place">Where the camera is, without the noise, which is each camera's own.</param>
/// <param name="Model">The elevation model, which tells how high the ground is.</param>
/// <param name="Ephemeris">What turns the axes, and tells where the Sun is.</param>
internal sealed record StatesKey(
    TrajectorySettings Place, ElevationModel Model, EphemerisChoice Ephemeris, Aberration Aberration, bool NeedsMotion, bool NeedsPath);
