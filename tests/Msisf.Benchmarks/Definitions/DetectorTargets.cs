namespace Msisf.Benchmarks.Definitions;

/// <summary>What the detector may cost for 1024 x 1024 px, on two cores.</summary>
internal static class DetectorTargets
{
    /// <summary>s: a point spread function of 15 x 15 px.</summary>
    public const double SpreadSeconds = 0.020;

    /// <summary>s: all kinds of noise.</summary>
    public const double NoiseSeconds = 0.015;
}
