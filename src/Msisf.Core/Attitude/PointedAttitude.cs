namespace Msisf.Core.Attitude;

/// <summary>A camera that looks at one target all along a trajectory.</summary>
/// <param name="pointing">How it points.</param>
/// <param name="scene">Terrain and Sun.</param>
public sealed class PointedAttitude(CameraPointing pointing, ISceneGeometry scene) : IAttitudeSource
{
    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) =>
        pointing.MoonFromCamera(point.PositionBodyFixed, point.Time, scene);
}
