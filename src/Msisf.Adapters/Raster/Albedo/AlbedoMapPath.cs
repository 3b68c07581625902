using Msisf.Adapters.Input;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// One map of the reflectance as <c>--albedo-map</c> names it: a path, what its values mean, and how it is scaled, as in
/// "site.tif,factor=auto".
/// </summary>
/// <param name="Path">The file or folder.</param>
/// <param name="Properties">What the user says of its values.</param>
/// <param name="Factor">By what they are multiplied too; null if the user does not say it.</param>
/// <param name="IsMatched">Whether the map is made as bright as the map around it.</param>
/// <param name="Options">The options as they are given; empty for none.</param>
public sealed record AlbedoMapPath(string Path, MapProperties Properties, double? Factor, bool IsMatched, string Options)
{
    private const string FactorStart = "factor=";

    /// <summary>Greatest factor: bytes and 16-bit numbers in place of I/F need less.</summary>
    private const double MaxFactor = 1e6;

    private const double MinFactor = 1e-12;

    /// <summary>Value of the factor for a map that is made as bright as the map around it.</summary>
    private const string Automatic = "auto";

    /// <summary>Whether only the file is named.</summary>
    public bool IsPlain => Options.Length == 0;

    /// <summary>Reads a text; a file whose name has commas in it is found as well.</summary>
    /// <exception cref="BadInputException">An option is unknown, given twice, or no number.</exception>
    public static AlbedoMapPath Parse(string text)
    {
        string[] parts = text.Split(',');
        int first = Array.FindIndex(parts, 1, part => part.Contains('=', StringComparison.Ordinal));
        if (first < 0 || System.IO.Path.Exists(text))
        {
            return new AlbedoMapPath(text, new MapProperties(), Factor: null, IsMatched: false, string.Empty);
        }

        string path = string.Join(',', parts[..first]);
        string[] factors = [.. parts[first..].Where(part => part.StartsWith(FactorStart, StringComparison.Ordinal))];
        string others = string.Join(',', parts[first..].Except(factors));
        string? factor = factors.Length > 0 ? factors[0][FactorStart.Length..] : null;
        double? number = factor is not null && NumberText.TryParse(factor, out double value) ? value : null;
        if (factors.Length > 1 || (factor is not null && factor != Automatic && number is not (>= MinFactor and <= MaxFactor)))
        {
            throw new BadInputException(
                $"{text}: factor is a number from 1E-12 to 1E6 by which the map's values are multiplied, or auto, given once.");
        }

        MapProperties properties = others.Length == 0 ? new MapProperties() : MapProperties.Parse(others);
        return new AlbedoMapPath(path, properties, number, factor == Automatic, string.Join(',', parts[first..]));
    }

    /// <summary>The text with another path.</summary>
    public string TextWith(string path) => IsPlain ? path : $"{path},{Options}";

    /// <inheritdoc/>
    public override string ToString() => TextWith(Path);
}
