namespace Msisf.Adapters.Manifest;

/// <summary>What was found of a frame.</summary>
/// <param name="Expected">The frame.</param>
/// <param name="State">How it stands.</param>
/// <param name="Reason">Why, in words; empty if it is right.</param>
public sealed record FrameCheck(ExpectedRecord Expected, FrameState State, string Reason);

/// <summary>How a frame that is to be there stands.</summary>
public enum FrameState
{
    /// <summary>There, and as it was made.</summary>
    Complete,

    /// <summary>Not there.</summary>
    Missing,

    /// <summary>There, but not as it was made.</summary>
    Damaged,

    /// <summary>There, but of other settings or another state of the spacecraft.</summary>
    OtherSettings,

    /// <summary>Not there, because it could not be made.</summary>
    Failed,
}

/// <summary>How closely a frame's files are looked at.</summary>
public enum CheckDepth
{
    /// <summary>That they are there, with their lengths.</summary>
    Lengths,

    /// <summary>Their content too, by its checksum.</summary>
    Checksums,
}
