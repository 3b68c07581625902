using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The orientation of a body-fixed frame in space. Safe for several threads.</summary>
public interface IFrameOrientation
{
    /// <summary>The times at which it is known.</summary>
    TdbCover Cover { get; }

    /// <summary>The rotation that turns J2000 components into those of the frame; null at a time that is not covered.</summary>
    RotationMatrix? FrameFromJ2000(TdbTime time);

    /// <summary>How fast the frame turns: rad/s relative to J2000, along J2000's axes; null at a time that is not covered.</summary>
    Vector3D? RateJ2000(TdbTime time);
}

/// <summary>A frame that is turned by a constant rotation from one whose orientation a binary PCK gives.</summary>
/// <param name="OrientationBody">NAIF's number of the orientation in the PCK (31006 for MOON_PA_DE421).</param>
public sealed record BodyFixedFrame(int OrientationBody, RotationMatrix FrameFromOrientation);
