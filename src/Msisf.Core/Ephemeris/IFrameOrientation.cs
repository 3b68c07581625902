namespace Msisf.Core.Ephemeris;

/// <summary>The orientation of a body-fixed frame in space. Safe for several threads.</summary>
public interface IFrameOrientation
{
    /// <summary>The times at which it is known.</summary>
    TdbCover Cover { get; }

    /// <summary>The rotation that turns J2000 components into those of the frame; null at a time that is not covered.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    RotationMatrix? FrameFromJ2000(double tdbSeconds);
}

/// <summary>A frame that is turned by a constant rotation from one whose orientation a binary PCK gives.</summary>
/// <param name="OrientationBody">NAIF's number of the orientation in the PCK (31006 for MOON_PA_DE421).</param>
public sealed record BodyFixedFrame(int OrientationBody, RotationMatrix FrameFromOrientation);

/// <summary>The orientation of a frame that binary PCK kernels give.</summary>
public sealed class KernelOrientation(SegmentTable segments, BodyFixedFrame frame) : IFrameOrientation
{
    /// <inheritdoc/>
    public TdbCover Cover => segments.CoverOf(frame.OrientationBody);

    /// <inheritdoc/>
    public RotationMatrix? FrameFromJ2000(double tdbSeconds)
    {
        if (segments.Find(frame.OrientationBody, tdbSeconds) is not { } segment)
        {
            return null;
        }

        Vector3D angles = segment.ValueAt(tdbSeconds);
        return frame.FrameFromOrientation * EulerAngles.ToRotation(angles.X, angles.Y, angles.Z);
    }
}
