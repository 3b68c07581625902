namespace Msisf.Core.Metadata;

/// <summary>What an input file of a frame is.</summary>
public enum InputKind
{
    /// <summary>The label of the elevation model, or of one of its parts.</summary>
    ElevationLabel,

    /// <summary>The samples of the elevation model, or of one of its parts; with an attached label that too.</summary>
    ElevationImage,

    /// <summary>A SPICE kernel.</summary>
    Kernel,

    /// <summary>A camera file.</summary>
    Camera,
}
