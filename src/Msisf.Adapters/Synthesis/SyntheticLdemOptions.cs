using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>What synthetic elevation model to write, and where.</summary>
/// <param name="PixelsPerDegree">
/// 1 to <see cref="SyntheticTerrain.LargestResolution"/>; with a base, an even multiple of its resolution.
/// </param>
/// <param name="Seed">Another seed is another terrain.</param>
/// <param name="OutputFolder">Made if it is missing.</param>
public sealed record SyntheticLdemOptions(int PixelsPerDegree, ulong Seed, string OutputFolder)
{
    /// <summary>The model whose terrain is refined; null for a made-up global shape.</summary>
    public IElevationGrid? Base { get; init; }

    /// <summary>The part to write; its samples are those of the whole Moon.</summary>
    public MoonRegion Region { get; init; } = MoonRegion.WholeMoon;

    /// <summary>
    /// The most threads to compute with; fewer are used where their blocks would take more than 220 MB. The bytes do not depend on it.
    /// </summary>
    public int Threads { get; init; } = Environment.ProcessorCount;
}
