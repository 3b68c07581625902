namespace Msisf.Core.Ephemeris;

/// <summary>How the frames of spacecraft and instruments are turned. Safe for several threads.</summary>
public interface ISpaceFrames
{
    /// <summary>The rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="frame">Name of the frame, e.g. "LRO_LROCNACL".</param>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    /// <exception cref="MsisfException">The frame is not known, or not at that time.</exception>
    RotationMatrix FrameFromJ2000(string frame, double tdbSeconds);
}
