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

    /// <summary>How fast the frame turns: rad/s relative to J2000, along its axes; null at a time that is not covered.</summary>
    /// <remarks>The kernel's angles turn about the axes 3, 1 and 3; each rate is about its axis as the turns before it leave it.</remarks>
    public Vector3D? RateJ2000(TdbTime time)
    {
        if (segments.Find(frame.OrientationBody, time) is not { } segment)
        {
            return null;
        }

        (Vector3D angles, Vector3D rates) = (segment.ValueAt(time), segment.RateAt(time));
        RotationMatrix afterFirst = RotationMatrix.FrameAboutZ(angles.X);
        RotationMatrix afterSecond = RotationMatrix.FrameAboutX(angles.Y) * afterFirst;
        return (rates.X * Vector3D.UnitZ) + (rates.Y * (afterFirst.Transposed * Vector3D.UnitX))
            + (rates.Z * (afterSecond.Transposed * Vector3D.UnitZ));
    }
}
