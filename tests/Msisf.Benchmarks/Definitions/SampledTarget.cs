using System.Globalization;

namespace Msisf.Benchmarks.Definitions;

/// <summary>What `--samples auto` may cost at most: the error of `--samples 16` in a part of its time.</summary>
/// <param name="Error">ERROR of auto:ERROR, levels of 255.</param>
/// <param name="Seconds">Drawing a further frame.</param>
internal sealed record SampledTarget(double Error, double Seconds)
{
    /// <summary>Measured too.</summary>
    public static IReadOnlyList<string> OtherSamples { get; } = ["auto:1"];

    /// <summary>Value of --samples.</summary>
    public string Samples => string.Create(CultureInfo.InvariantCulture, $"auto:{Error}");
}
