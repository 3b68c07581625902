namespace Msisf.Benchmarks.Definitions;

/// <summary>What the sequence must do, on two cores.</summary>
internal static class SequenceTargets
{
    /// <summary>With images and meta files.</summary>
    public const double FramesPerSecond = 80.0;

    /// <summary>Of the descent.</summary>
    public const double DescentFramesPerSecond = 20.0;

    /// <summary>With all layers in double precision on top.</summary>
    public const double LayeredFramesPerSecond = 1.6;

    /// <summary>
    /// 1: of the first frames' rate, what the last frames' must reach to be called flat; a shared machine's noise is about that.
    /// </summary>
    public const double MinLastToFirst = 0.9;

    /// <summary>1: of the own memory after a twentieth of the frames, what the last frames' may be to be called no growth.</summary>
    public const double MaxMemoryGrowth = 1.1;
}
