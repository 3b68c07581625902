using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Ephemeris;
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
    /// <summary>Samples a degree: from this resolution on floats are the default.</summary>
    public const int FirstResolutionOfFloats = 64;

    /// <summary>The body; the terrain of another one than the Moon is the Moon's, as many degrees wide and as many metres high.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>The model whose terrain is refined; null for a made-up global shape.</summary>
    public IGlobalGrid? Base { get; init; }

    /// <summary>The part with detail; its samples are those of a model with detail everywhere.</summary>
    public MoonRegion Region { get; init; } = MoonRegion.WholeMoon;

    /// <summary>What lies outside the region.</summary>
    public SyntheticRest Rest { get; init; }

    /// <summary>How the samples are stored.</summary>
    public SyntheticSampleFormat Format { get; init; } = DefaultFormat(PixelsPerDegree);

    /// <summary>
    /// The format if none is asked for: floats from 64 samples a degree on, because steps of 0.5 m show where samples lie close together.
    /// </summary>
    public static SyntheticSampleFormat DefaultFormat(int pixelsPerDegree) =>
        pixelsPerDegree < FirstResolutionOfFloats ? SyntheticSampleFormat.Integers : SyntheticSampleFormat.Floats;

    /// <summary>
    /// The most threads to compute with; fewer are used where their blocks would take more than 220 MB. The bytes do not depend on it.
    /// </summary>
    public int Threads { get; init; } = Environment.ProcessorCount;

    /// <summary>
    /// Name of the product, e.g. "LDEM_64_SYNTHETIC", or "LDEM_512_SYNTHETIC_00N_45N_000_090" for a part, borders named as in the LOLA
    /// archive.
    /// </summary>
    public string ProductId
    {
        get
        {
            string kind = Body.IsMoon ? "LDEM" : $"{Body.CapitalName}_DEM";
            string whole = Invariant($"{kind}_{PixelsPerDegree}_{LdemLabel.SyntheticMark}");
            return Region == MoonRegion.WholeMoon ? whole : $"{whole}_{LdemPartName.BordersOf(Region)}";
        }
    }

    /// <summary>The part of the Moon that the image covers.</summary>
    public MoonRegion Cover => Rest == SyntheticRest.None ? Region : MoonRegion.WholeMoon;

    /// <summary>Lines of the image.</summary>
    public int Lines => LinesOf(Cover);

    /// <summary>Samples of a line.</summary>
    public int LineSamples => SamplesOf(Cover);

    /// <summary>Bytes of the image.</summary>
    public long Bytes => (long)Format.SampleBytes * Lines * LineSamples;

    /// <summary>Bytes that the image takes on the disk: of a flat rest nothing is stored.</summary>
    public long StoredBytes => Rest == SyntheticRest.Flat ? (long)Format.SampleBytes * LinesOf(Region) * SamplesOf(Region) : Bytes;

    private int LinesOf(MoonRegion region) => (region.NorthDegrees - region.SouthDegrees) * PixelsPerDegree;

    private int SamplesOf(MoonRegion region) => (region.EastDegrees - region.WestDegrees) * PixelsPerDegree;
}

/// <summary>The map projection of a synthetic model.</summary>
public enum SyntheticProjection
{
    /// <summary>Latitude and longitude.</summary>
    Cylindrical,

    /// <summary>Polar stereographic around the south pole.</summary>
    PolarSouth,

    /// <summary>Polar stereographic around the north pole.</summary>
    PolarNorth,
}

/// <summary>What a synthetic model has outside its region.</summary>
public enum SyntheticRest
{
    /// <summary>The base, interpolated; the detail fades out beyond the region's border.</summary>
    Base,

    /// <summary>The reference sphere: zeros, which a sparse file does not store.</summary>
    Flat,

    /// <summary>Nothing: the product is a part of the Moon, as those of NASA's split products.</summary>
    None,
}
