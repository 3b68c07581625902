namespace Msisf.Adapters.Manifest;

/// <summary>The result of checking a frame.</summary>
/// <param name="Reason">Why, in words; empty if it is complete.</param>
public sealed record FrameCheck(ExpectedRecord Expected, FrameState State, string Reason);

/// <summary>The state of a frame that a run expects.</summary>
public enum FrameState
{
    /// <summary>The files are as they were made.</summary>
    Complete,

    /// <summary>The files do not exist.</summary>
    Missing,

    /// <summary>The files are not as they were made.</summary>
    Damaged,

    /// <summary>The files belong to other settings or another state of the spacecraft.</summary>
    OtherSettings,

    /// <summary>The frame could not be made.</summary>
    Failed,
}

/// <summary>What of a frame's files is checked.</summary>
public enum CheckDepth
{
    /// <summary>That they exist, with their lengths.</summary>
    Lengths,

    /// <summary>Their content too, by its checksum.</summary>
    Checksums,
}
