using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>A scene whose Sun is where the user says, so that what looks at the Sun looks at the one that gives the light.</summary>
/// <param name="scene">All else.</param>
/// <param name="sunPositionMoonMe">m.</param>
public sealed class SceneWithSun(ISceneGeometry scene, Vector3D sunPositionMoonMe) : ISceneGeometry
{
    /// <inheritdoc/>
    public double ReferenceRadius => scene.ReferenceRadius;

    /// <inheritdoc/>
    public double GroundRadius(Vector3D directionMoonMe) => scene.GroundRadius(directionMoonMe);

    /// <inheritdoc/>
    public Vector3D SunPositionMoonMe(ModifiedJulianDate time) => sunPositionMoonMe;

    /// <inheritdoc/>
    public RotationMatrix MoonMeFromJ2000(ModifiedJulianDate time) => scene.MoonMeFromJ2000(time);

    /// <summary>The scene with this Sun; the scene itself if there is none.</summary>
    public static ISceneGeometry Of(ISceneGeometry scene, Vector3D? sunPositionMoonMe) =>
        sunPositionMoonMe is { } sun ? new SceneWithSun(scene, sun) : scene;
}
