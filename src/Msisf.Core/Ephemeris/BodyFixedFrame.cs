using Msisf.Core.Numerics;

namespace Msisf.Core.Ephemeris;

/// <summary>A frame that is turned by a constant rotation from one whose orientation a binary PCK gives.</summary>
/// <param name="OrientationBody">NAIF's number of the orientation in the PCK (31006 for MOON_PA_DE421).</param>
/// <param name="FrameFromOrientation">The constant rotation.</param>
public sealed record BodyFixedFrame(int OrientationBody, RotationMatrix FrameFromOrientation);
