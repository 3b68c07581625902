using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Camera;

/// <summary>
/// Where a camera is and how it points at each time: what a frame needs at its time, and a camera that scans at the time of each row. Safe
/// for several threads.
/// </summary>
public interface ICameraPath
{
    /// <summary>The times at which both are known.</summary>
    TdbCover Cover { get; }

    /// <summary>The camera at a time.</summary>
    /// <returns>Its place and orientation in MOON_ME of that time; its own seconds are 0.</returns>
    /// <exception cref="MsisfException">The time is outside the cover, which the message names, or the data are damaged.</exception>
    CameraState At(Instant time);
}

/// <summary>Where a camera is while it sees some rows.</summary>
/// <param name="PositionBodyFixed">Focal point, m, body-fixed.</param>
/// <param name="MoonFromCamera">Orientation: turns camera axes into Moon axes.</param>
/// <param name="Seconds">s after the frame's time.</param>
/// <param name="SunPositionBodyFixed">The Sun at that time, m, body-fixed; null for that of the frame's time.</param>
public readonly record struct CameraState(
    Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera, double Seconds = 0.0, Vector3D? SunPositionBodyFixed = null);

/// <summary>Neighbouring rows of an image that a camera sees in one state.</summary>
/// <param name="Camera">Sees these rows only: its first row is the first of them.</param>
public readonly record struct CameraBand(PixelRows Rows, FrameCamera Camera);
