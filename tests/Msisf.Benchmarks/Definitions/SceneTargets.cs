namespace Msisf.Benchmarks.Definitions;

/// <summary>What a scene may cost at most, on two cores.</summary>
/// <param name="FirstSeconds">From the start of the process to its end, all files written.</param>
/// <param name="FurtherSeconds">Drawing a further frame.</param>
/// <param name="MemoryBytes">Most memory that the process of one frame held.</param>
/// <param name="TimesFasterThanPovRay">
/// How many further frames take as long as POV-Ray's way to one image; null where nothing is asked for.
/// </param>
/// <param name="Sampled">What samples where they matter may cost; null where it is not measured.</param>
internal sealed record SceneTargets(
    double FirstSeconds, double FurtherSeconds, double MemoryBytes, double? TimesFasterThanPovRay = null, SampledTarget? Sampled = null);
