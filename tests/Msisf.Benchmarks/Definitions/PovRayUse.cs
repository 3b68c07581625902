namespace Msisf.Benchmarks.Definitions;

/// <summary>How POV-Ray's way is measured for a scene; it takes seconds to minutes.</summary>
internal enum PovRayUse
{
    /// <summary>In turn with the native renderer; also without antialiasing, which the native renderer's one sample a pixel has not.</summary>
    Repeatedly,

    /// <summary>One run: minutes of parsing.</summary>
    Once,

    /// <summary>Not at all: its patterns would fill the disk.</summary>
    No,
}
