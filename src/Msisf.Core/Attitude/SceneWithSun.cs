using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>A scene whose Sun is where the user says, so that what looks at the Sun looks at the one that gives the light.</summary>
/// <param name="scene">All else.</param>
/// <param name="sunPositionBodyFixed">m.</param>
public sealed class SceneWithSun(ISceneGeometry scene, Vector3D sunPositionBodyFixed) : ISceneGeometry
{
    /// <inheritdoc/>
    public CelestialBody Body => scene.Body;

    /// <inheritdoc/>
    public double ReferenceRadius => scene.ReferenceRadius;

    /// <inheritdoc/>
    public TimeScale TimeScale => scene.TimeScale;

    /// <inheritdoc/>
    public double GroundRadius(Vector3D directionBodyFixed) => scene.GroundRadius(directionBodyFixed);

    /// <inheritdoc/>
    public Vector3D SunPositionBodyFixed(Instant time) => sunPositionBodyFixed;

    /// <inheritdoc/>
    public RotationMatrix BodyFromJ2000(Instant time) => scene.BodyFromJ2000(time);

    /// <summary>The scene with this Sun; the scene itself if there is none.</summary>
    public static ISceneGeometry Of(ISceneGeometry scene, Vector3D? sunPositionBodyFixed) =>
        sunPositionBodyFixed is { } sun ? new SceneWithSun(scene, sun) : scene;
}
