namespace Msisf.Adapters.Manifest;

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
