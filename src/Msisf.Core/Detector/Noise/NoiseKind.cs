namespace Msisf.Core.Detector.Noise;

/// <summary>What random numbers are for. The number of a kind is part of the generator's counter and never changes.</summary>
internal enum NoiseKind : byte
{
    /// <summary>Number of electrons that the mean signal of a pixel gives.</summary>
    Shot = 1,

    /// <summary>Read noise of a pixel.</summary>
    Read = 2,

    /// <summary>Number of cosmic rays in a frame.</summary>
    RayCount = 3,

    /// <summary>Where a cosmic ray enters the detector.</summary>
    RayPosition = 4,

    /// <summary>Direction of a cosmic ray.</summary>
    RayDirection = 5,

    /// <summary>Response of a pixel (PRNU); the same in all frames.</summary>
    Response = 6,

    /// <summary>Dark current of a pixel (DSNU); the same in all frames.</summary>
    DarkCurrent = 7,

    /// <summary>Offset of a column; the same in all frames.</summary>
    ColumnOffset = 8,

    /// <summary>Whether a pixel is hot or dead; the same in all frames.</summary>
    Defect = 9,
}
