using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>Where a camera is while it sees some rows.</summary>
/// <param name="PositionMoonMe">Focal point, m, MOON_ME.</param>
/// <param name="MoonFromCamera">Orientation: turns camera axes into Moon axes.</param>
/// <param name="Seconds">s after the frame's time.</param>
/// <param name="SunPositionMoonMe">The Sun at that time, m, MOON_ME; null for that of the frame's time.</param>
public readonly record struct CameraState(
    Vector3D PositionMoonMe, UnitQuaternion MoonFromCamera, double Seconds = 0.0, Vector3D? SunPositionMoonMe = null);

/// <summary>Neighbouring rows of an image that a camera sees in one state.</summary>
/// <param name="Rows">The rows.</param>
/// <param name="Camera">Sees these rows only: its first row is the first of them.</param>
public readonly record struct CameraBand(PixelRows Rows, FrameCamera Camera);
