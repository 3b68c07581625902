namespace Msisf.Core.Ephemeris;

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
