using System.Globalization;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>A map projection in PROJ's form: "+proj=stere +lat_0=-90 +R=1737400 +units=m".</summary>
/// <param name="text">The text.</param>
internal sealed class ProjText(string text)
{
    private readonly Dictionary<string, string> _words = text
        .Split(' ', StringSplitOptions.RemoveEmptyEntries)
        .Select(word => word.TrimStart('+').Split('=', 2))
        .GroupBy(pair => pair[0], StringComparer.Ordinal)
        .ToDictionary(group => group.Key, group => group.First() is [_, var value] ? value : string.Empty, StringComparer.Ordinal);

    /// <summary>The projection's name.</summary>
    public string Name => _words.GetValueOrDefault("proj", string.Empty);

    /// <summary>m: the radius of the sphere; null for an ellipsoid or a datum by name.</summary>
    public double? Radius => Number("R") ?? (Number("a") is double a && a == Number("b") ? a : null);

    /// <summary>m: length of a unit of map coordinates.</summary>
    public double MetresPerUnit => Number("to_meter") ?? (_words.GetValueOrDefault("units", "m") switch
    {
        "m" => 1.0,
        "km" => 1000.0,
        _ => double.NaN,
    });

    /// <summary>A number by its name; null if it is missing or no number.</summary>
    public double? Number(string name) => _words.TryGetValue(name, out string? value)
        && double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;

    /// <summary>The text.</summary>
    public override string ToString() => text.Trim();
}
