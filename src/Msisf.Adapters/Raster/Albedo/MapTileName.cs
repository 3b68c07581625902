using System.Text.RegularExpressions;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// The name of a tile of a map: LROC's archive puts projection and centre into it, e.g. "WAC_EMP_643NM_E300N0450_304P" for 30.0 N 45.0 E.
/// </summary>
/// <param name="Map">The name without the centre, which the tiles of one map have in common, e.g. "WAC_EMP_643NM_304P".</param>
/// <param name="HasCentre">Whether the name has a centre; if not, the map is in one file.</param>
internal sealed partial record MapTileName(string Map, bool HasCentre)
{
    /// <summary>Takes a product's name apart.</summary>
    public static MapTileName Of(string product) => Centre().Match(product) is { Success: true } centre
        ? new MapTileName((product[..centre.Index] + product[(centre.Index + centre.Length)..]).ToUpperInvariant(), HasCentre: true)
        : new MapTileName(product.ToUpperInvariant(), HasCentre: false);

    [GeneratedRegex("_[A-Z][0-9]{3}[NS][0-9]{4}(?=[_.]|$)", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Centre();
}
