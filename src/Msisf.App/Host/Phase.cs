namespace Msisf.App.Host;

/// <summary>The parts of a run that <c>--timing</c> tells apart.</summary>
internal enum Phase
{
    /// <summary>From the start of the process to the first line of the program's own work.</summary>
    StartUp,

    /// <summary>States of the spacecraft: reading, orbit, attitude.</summary>
    States,

    /// <summary>Ephemeris engine, kernels, Sun positions.</summary>
    Sun,

    /// <summary>Opening the elevation model and its summary.</summary>
    Model,

    /// <summary>Checksums of the inputs, the manifest, and the check of frames that are there.</summary>
    Manifest,

    /// <summary>Choosing the tiles.</summary>
    Selection,

    /// <summary>Checking and making patterns.</summary>
    Patterns,

    /// <summary>POV-Ray as a process, from start to exit.</summary>
    PovRay,

    /// <summary>What POV-Ray says of its parsing.</summary>
    Parse,

    /// <summary>What POV-Ray says of its tracing.</summary>
    Trace,

    /// <summary>Drawing by the program's own renderer.</summary>
    Draw,

    /// <summary>Image, scene and annotation files.</summary>
    Output,

    /// <summary>The meta file with its pixels.</summary>
    Xml,

    /// <summary>The ground truth of every pixel.</summary>
    Layers,
}
