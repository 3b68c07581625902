using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>What synthetic polar map to write, and where.</summary>
/// <param name="IsSouth">Whether it is of the south pole.</param>
/// <param name="MetresPerPixel">Map scale, m.</param>
/// <param name="LatitudeDegrees">Absolute latitude of the middle of the map's sides.</param>
/// <param name="Seed">Another seed is another terrain.</param>
/// <param name="OutputFolder">Made if it is missing.</param>
public sealed record SyntheticMapOptions(bool IsSouth, double MetresPerPixel, double LatitudeDegrees, ulong Seed, string OutputFolder)
{
    /// <summary>The model whose terrain is refined; null for a made-up global shape.</summary>
    public IGlobalGrid? Base { get; init; }

    /// <summary>How the samples are stored.</summary>
    public SyntheticSampleFormat Format { get; init; } = SyntheticSampleFormat.Floats;

    /// <summary>The most threads to compute with. The bytes do not depend on it.</summary>
    public int Threads { get; init; } = Environment.ProcessorCount;

    /// <summary>Samples along a side of the map: the most that lie within the latitude in the middle of the sides.</summary>
    public int Side => 2 * (int)Math.Floor(
        2.0 * MoonConstants.ReferenceRadius * Math.Tan(double.DegreesToRadians(0.5 * (90.0 - LatitudeDegrees))) / MetresPerPixel);

    /// <summary>Bytes of the image.</summary>
    public long Bytes => (long)Format.SampleBytes * Side * Side;

    /// <summary>The map, with the pole in its middle.</summary>
    public PolarStereographic Projection => new(IsSouth, MetresPerPixel, 0.5 * (Side - 1), 0.5 * (Side - 1));

    /// <summary>E.g. "LDEM_80S_20M_SYNTHETIC", "LDEM_875N_5M_SYNTHETIC", named as in the LOLA archive.</summary>
    public string ProductId => Invariant(
        $"LDEM_{LatitudeDegrees:R}{(IsSouth ? 'S' : 'N')}_").Replace(".", string.Empty, StringComparison.Ordinal)
        + Invariant($"{MetresPerPixel:R}M_{LdemLabel.SyntheticMark}");
}
