namespace Msisf.App.Host;

/// <summary>The parts of a run whose times <c>--timing</c> prints separately.</summary>
internal enum Phase
{
    /// <summary>From the start of the process to the first line of the program's own work.</summary>
    StartUp,

    /// <summary>From there to the beginning of the run: parsing and reading the options.</summary>
    Options,

    /// <summary>Reading or computing the spacecraft's states: positions, times and attitudes.</summary>
    States,

    /// <summary>Opening the ephemeris engine and its kernels, and computing the Sun's positions.</summary>
    Sun,

    /// <summary>Opening the elevation model and its summary.</summary>
    Model,

    /// <summary>Telling from the cameras what the images will show.</summary>
    Preview,

    /// <summary>Checksums of the inputs, the manifest, and the check of existing frames.</summary>
    Manifest,

    /// <summary>Selection of the tiles.</summary>
    Selection,

    /// <summary>Checking and making patterns.</summary>
    Patterns,

    /// <summary>Running POV-Ray, from the start of its process to its exit.</summary>
    PovRay,

    /// <summary>Parse time that POV-Ray reports.</summary>
    Parse,

    /// <summary>Trace time that POV-Ray reports.</summary>
    Trace,

    /// <summary>Drawing by the program's own renderer.</summary>
    Draw,

    /// <summary>Turning the light of a frame into the numbers of the camera's detector.</summary>
    Detector,

    /// <summary>Writing the image, scene and annotation files.</summary>
    Output,

    /// <summary>Writing the meta file with its pixels.</summary>
    Xml,

    /// <summary>Reading catalogues, finding the craters of frames, and writing their files.</summary>
    Navigation,

    /// <summary>Writing the layers: the ground truth of every pixel.</summary>
    Layers,
}
