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

    /// <summary>A map of the Moon's reflectance.</summary>
    AlbedoMap,

    /// <summary>A map of Hapke's parameters.</summary>
    HapkeMap,

    /// <summary>A camera file.</summary>
    Camera,

    /// <summary>Small turns of the camera.</summary>
    Jitter,

    /// <summary>Several cameras on one body.</summary>
    Rig,

    /// <summary>A catalogue of craters.</summary>
    CraterCatalogue,

    /// <summary>A list of landmarks.</summary>
    Landmarks,

    /// <summary>A catalogue of stars.</summary>
    StarCatalogue,
}
