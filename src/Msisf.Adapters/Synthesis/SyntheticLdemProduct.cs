using System.Globalization;
using Msisf.Adapters.Terrain;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>Name and size of a synthetic product.</summary>
/// <param name="PixelsPerDegree">Samples a degree.</param>
/// <param name="Region">The part of the Moon in it.</param>
public sealed record SyntheticLdemProduct(int PixelsPerDegree, MoonRegion Region)
{
    /// <summary>
    /// E.g. "LDEM_64_SYNTHETIC", or "LDEM_512_SYNTHETIC_00N_45N_000_090" for a part, borders named as in the LOLA archive.
    /// </summary>
    public string ProductId
    {
        get
        {
            string whole = string.Create(CultureInfo.InvariantCulture, $"LDEM_{PixelsPerDegree}_{LdemLabel.SyntheticMark}");
            return Region == MoonRegion.WholeMoon ? whole : $"{whole}_{LdemPartName.BordersOf(Region)}";
        }
    }

    /// <summary>Lines of the image.</summary>
    public int Lines => (Region.NorthDegrees - Region.SouthDegrees) * PixelsPerDegree;

    /// <summary>Samples of a line.</summary>
    public int LineSamples => (Region.EastDegrees - Region.WestDegrees) * PixelsPerDegree;

    /// <summary>Bytes of the image: two a sample.</summary>
    public long Bytes => 2L * Lines * LineSamples;
}
