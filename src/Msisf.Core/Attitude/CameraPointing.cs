using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>How a camera points, said without a quaternion: what it looks at, what is up, and a roll. The default is the nadir.</summary>
public sealed record CameraPointing
{
    /// <summary>What the camera looks at.</summary>
    public BoresightKind Kind { get; init; }

    /// <summary>The place that it looks at (<see cref="BoresightKind.Place"/>).</summary>
    public SurfacePlace Target { get; init; }

    /// <summary>rad: angle from the nadir (<see cref="BoresightKind.OffNadir"/>).</summary>
    public double OffNadir { get; init; }

    /// <summary>rad: clockwise from north (<see cref="BoresightKind.OffNadir"/>, <see cref="BoresightKind.Horizon"/>).</summary>
    public double Azimuth { get; init; }

    /// <summary>What points up in the image. Where the line of sight is parallel to it, north does.</summary>
    public UpDirection Up { get; init; }

    /// <summary>rad: turns the camera about its line of sight, clockwise as seen from behind it.</summary>
    public double Roll { get; init; }

    /// <summary>The attitude of a camera that points so.</summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into Moon axes.</returns>
    /// <exception cref="Errors.BadInputException">The camera is in the Moon's centre, or at the place that it looks at.</exception>
    public UnitQuaternion MoonFromCamera(Vector3D positionBodyFixed, Instant time, ISceneGeometry scene)
    {
        // Refuses the Moon's centre, where no direction below has a meaning.
        UnitQuaternion nadir = NadirPointing.MoonFromCamera(positionBodyFixed);
        Vector3D forward = Kind switch
        {
            BoresightKind.Place => Boresight.Towards(positionBodyFixed, PlaceOfTarget(scene)),
            BoresightKind.Sun => Boresight.Towards(positionBodyFixed, scene.SunPositionBodyFixed(time)),
            BoresightKind.Horizon => Boresight.Horizon(positionBodyFixed, Azimuth, scene.ReferenceRadius),
            BoresightKind.OffNadir => Boresight.OffNadir(positionBodyFixed, OffNadir, Azimuth),
            _ => nadir * -Vector3D.UnitX,
        };
        Vector3D up = Up switch
        {
            UpDirection.North => Vector3D.UnitZ,
            UpDirection.Sun => scene.SunPositionBodyFixed(time) - positionBodyFixed,
            _ => positionBodyFixed,
        };
        return Boresight.MoonFromCamera(positionBodyFixed, forward, up, Roll);
    }

    /// <summary>Whether the camera looks at a place beyond its horizon, so that it sees the ground in between.</summary>
    /// <param name="positionBodyFixed">Camera, m, body-fixed.</param>
    public bool IsTargetHidden(Vector3D positionBodyFixed, ISceneGeometry scene) =>
        Kind == BoresightKind.Place
        && SightLine.IsBlocked(positionBodyFixed, PlaceOfTarget(scene), scene.GroundRadius);

    private Vector3D PlaceOfTarget(ISceneGeometry scene) => Target.ToPositionBodyFixed(scene.GroundRadius, scene.ReferenceRadius);
}

/// <summary>Which direction points up in the image, as far as the line of sight allows.</summary>
public enum UpDirection
{
    /// <summary>Away from the Moon's centre, so that the horizon is level; the default.</summary>
    Zenith,

    /// <summary>The Moon's north pole.</summary>
    North,

    /// <summary>The Sun.</summary>
    Sun,
}

/// <summary>A camera that looks at one target all along a trajectory.</summary>
public sealed class PointedAttitude(CameraPointing pointing, ISceneGeometry scene) : IAttitudeSource
{
    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) =>
        pointing.MoonFromCamera(point.PositionBodyFixed, point.Time, scene);
}
