using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>Name and size of a synthetic product.</summary>
/// <param name="PixelsPerDegree">Samples a degree.</param>
/// <param name="Region">The part of the Moon with detail.</param>
/// <param name="Rest">What lies outside it.</param>
/// <param name="Format">How samples are stored.</param>
public sealed record SyntheticLdemProduct(int PixelsPerDegree, MoonRegion Region, SyntheticRest Rest, SyntheticSampleFormat Format)
{
    /// <summary>The body.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>The body as the label's description names it.</summary>
    public string BodyInText => Body.IsMoon ? "a Moon" : $"a {Body.Name}";

    /// <summary>
    /// E.g. "LDEM_64_SYNTHETIC", or "LDEM_512_SYNTHETIC_00N_45N_000_090" for a part, borders named as in the LOLA archive.
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
