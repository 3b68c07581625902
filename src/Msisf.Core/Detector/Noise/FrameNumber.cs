using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Time;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// The number that tells the noise of one frame from that of another: a hash of its time, position and orientation. It does not depend on
/// the frame's place in a run, so a frame that is made again alone, or on another machine, gets the same noise. The time is taken as it is
/// printed, as an MJD, so that a frame that is made again from a table gets it too.
/// </summary>
public static class FrameNumber
{
    /// <summary>The number of a frame.</summary>
    /// <param name="time">Time of the frame.</param>
    /// <param name="camera">Its position and orientation count.</param>
    public static ulong Of(Instant time, ICamera camera)
    {
        Vector3D position = camera.PositionBodyFixed;
        UnitQuaternion orientation = camera.MoonFromCamera;
        ulong hash = 0;
        foreach (double number in (ReadOnlySpan<double>)[
            time.Mjd, position.X, position.Y, position.Z, orientation.X, orientation.Y, orientation.Z, orientation.W])
        {
            ulong bits = BitConverter.DoubleToUInt64Bits(number + 0.0); // -0 counts as 0
            (uint first, uint second, _, _) = Philox4x32.Block(((uint)bits, (uint)(bits >> 32), 0, 0), hash);
            hash = first | ((ulong)second << 32);
        }

        return hash;
    }
}
