using System.Globalization;
using Msisf.Core.Terrain.Synthesis;

namespace Msisf.Adapters.Terrain;

/// <summary>Name and size of a synthetic product.</summary>
/// <param name="PixelsPerDegree">Samples a degree.</param>
/// <param name="Region">The part of the Moon in it.</param>
public sealed record SyntheticLdemProduct(int PixelsPerDegree, MoonRegion Region)
{
    /// <summary>What every name and label of a synthetic product holds.</summary>
    public const string Mark = "SYNTHETIC";

    /// <summary>E.g. "LDEM_64_SYNTHETIC", or "LDEM_512_SYNTHETIC_00N_45N_000_090" for a part, borders named as in the LOLA archive.</summary>
    public string ProductId
    {
        get
        {
            string whole = string.Create(CultureInfo.InvariantCulture, $"LDEM_{PixelsPerDegree}_{Mark}");
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
