namespace Msisf.Adapters.Fetching;

/// <summary>NASA's elevation models of the whole Moon: LOLA's cylindrical LDEM products (data set LRO-L-LOLA-4-GDR-V1.0).</summary>
public static class LdemProducts
{
    /// <summary>Degrees of latitude and longitude of one product of a split model, by its resolution.</summary>
    private static readonly Dictionary<int, (int High, int Wide)> Splits = new() { [256] = (90, 180), [512] = (45, 90), [1024] = (15, 30) };

    /// <summary>The resolutions, px/deg.</summary>
    public static IReadOnlyList<int> Resolutions { get; } = [4, 16, 64, 128, .. Splits.Keys];

    /// <summary>The names of the products that make up a model, from the north, without endings.</summary>
    /// <param name="resolution">One of <see cref="Resolutions"/>.</param>
    /// <param name="hasFloats">Whether samples are 32-bit floats in place of 16-bit steps of 0.5 m.</param>
    public static IEnumerable<string> Of(int resolution, bool hasFloats)
    {
        string ending = hasFloats ? "_FLOAT" : string.Empty;
        if (!Splits.TryGetValue(resolution, out (int High, int Wide) split))
        {
            return [$"LDEM_{resolution}{ending}"];
        }

        return from south in Steps(90 - split.High, -90, -split.High)
               from west in Steps(0, 360 - split.Wide, split.Wide)
               select Invariant($"LDEM_{resolution}_{Latitudes(south, split.High)}_{west:000}_{west + split.Wide:000}{ending}");
    }

    /// <summary>The folders in which NASA keeps them, in the order in which they are asked.</summary>
    /// <param name="hasFloats">As in <see cref="Of"/>.</param>
    public static IReadOnlyList<LdemSite> Sites(bool hasFloats)
    {
        string images = hasFloats ? "float_img" : "img";
        return
        [
            new(
                $"https://pds-geosciences.wustl.edu/lro/lro-l-lola-3-rdr-v1/lrolol_1xxx/data/lola_gdr/cylindrical/{images}",
                HasCapitals: false),
            new($"https://imbrium.mit.edu/DATA/LOLA_GDR/CYLINDRICAL/{images.ToUpperInvariant()}", HasCapitals: true),
        ];
    }

    /// <summary>As in the archive: 45N_90N, 00N_45N, and south of the equator 45S_00S.</summary>
    private static string Latitudes(int south, int high) => south >= 0
        ? Invariant($"{south:00}N_{south + high:00}N")
        : Invariant($"{-south:00}S_{-south - high:00}S");

    private static IEnumerable<int> Steps(int first, int last, int step)
    {
        for (int value = first; step > 0 ? value <= last : value >= last; value += step)
        {
            yield return value;
        }
    }
}

/// <summary>A place with elevation models.</summary>
/// <param name="Place">A folder, or its address.</param>
/// <param name="HasCapitals">Whether the names of its files are in capitals, not in small letters.</param>
public sealed record LdemSite(string Place, bool HasCapitals)
{
    /// <summary>The name under which a file is there.</summary>
    public string NameOf(string name) => HasCapitals ? name.ToUpperInvariant() : name.ToLowerInvariant();
}
