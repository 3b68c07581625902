using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The orientation of a frame that binary PCK kernels give.</summary>
public sealed class KernelOrientation(SegmentTable segments, BodyFixedFrame frame) : IFrameOrientation
{
    /// <inheritdoc/>
    public TdbCover Cover => segments.CoverOf(frame.OrientationBody);

    /// <inheritdoc/>
    public RotationMatrix? FrameFromJ2000(TdbTime time)
    {
        if (segments.Find(frame.OrientationBody, time) is not { } segment)
        {
            return null;
        }

        Vector3D angles = segment.ValueAt(time);
        return frame.FrameFromOrientation * EulerAngles.ToRotation(angles.X, angles.Y, angles.Z);
    }

    /// <inheritdoc/>
    public Vector3D? RateJ2000(TdbTime time) => segments.Find(frame.OrientationBody, time) is { } segment
        ? EulerAngles.ToRateJ2000(segment.ValueAt(time), segment.RateAt(time))
        : null;
}
