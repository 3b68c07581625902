using Msisf.Adapters.States;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Adapters.CameraExport;

/// <summary>What camera models for other programs are made from.</summary>
/// <param name="Name">File name of the image, without extension.</param>
/// <param name="Camera">The camera in its state.</param>
/// <param name="Time">When.</param>
/// <param name="SunPosition">m, in the body's frame; with a lamp at the camera the camera's position.</param>
/// <param name="Globe">The body.</param>
public sealed record ExportedFrame(string Name, FrameCamera Camera, Instant Time, Vector3D SunPosition, DrawnGlobe Globe)
{
    /// <summary>For formats that need it: what time TDB is, and how the body is turned.</summary>
    public IEphemeris? Ephemeris { get; init; }

    /// <summary>For formats that hold pixels.</summary>
    public ExportedImage? Image { get; init; }

    /// <summary>How the image was scanned; the camera is then that of one exposure. Null for a frame.</summary>
    public ExportedScan? Scan { get; init; }

    /// <summary>Whether the camera moved while a frame was exposed, of which the meta file does not say how a shutter rolled.</summary>
    public bool IsMoving { get; init; }

    /// <summary>The scan as USGSCSM has it; null for a frame.</summary>
    internal CsmScan? Csm { get; init; }

    /// <summary>px: height of the image.</summary>
    internal int Height => Camera.Height * (Scan is { Kind: not ScanKind.RollingShutter } scan ? scan.Count : 1);

    /// <summary>TDB seconds past J2000.</summary>
    internal double TdbSeconds => Time.Tdb.Seconds;

    /// <summary>Turns J2000 into the body's frame.</summary>
    internal RotationMatrix BodyFromJ2000 => BodyFromJ2000At(TdbSeconds);

    /// <summary>The same at another time.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    internal RotationMatrix BodyFromJ2000At(double tdbSeconds) => Ephemeris!.BodyFromJ2000(tdbSeconds);

    /// <summary>Turns OpenCV's camera axes (x right, y down, z forward) into the body's frame.</summary>
    internal UnitQuaternion BodyFromOpenCv => StateTables.OpenCv(State);

    /// <summary>Time and pose.</summary>
    internal SpacecraftState State => new(Time, Camera.PositionBodyFixed, Camera.MoonFromCamera);
}
