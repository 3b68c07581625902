using System.Text.Json;
using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.App.DataSets;

/// <summary>A file or model that a data set is made from.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Sha256">Its checksum; of a model that of parts of its files.</param>
/// <param name="Licence">How it may be used.</param>
internal sealed record DataSetSource(string Kind, string Name, string Sha256, string Licence)
{
    private const string Nasa = "public domain (NASA)";
    private const string Made = "made by msis; no rights are reserved";

    /// <summary>Checks that the licence of each file that the user names is known, before anything is drawn.</summary>
    /// <param name="spec">Has the licences that the user knows.</param>
    /// <exception cref="BadInputException">A licence is missing.</exception>
    public static void RequireLicences(DataSetSpec spec, RenderSettings settings, ElevationModel model, SurfaceInputs maps)
    {
        IEnumerable<string> names =
        [
            .. model.Sets.Select(set => set.ProductId), .. maps.Files.Select(file => file.Name),
            .. new[] { settings.Native.Navigation?.Craters, settings.Native.Navigation?.Landmarks, settings.Native.Sky?.Catalogue }
                .OfType<string>().Select(path => Path.GetFileName(path)),
            .. settings.Kernels.Select(path => Path.GetFileName(path)),
        ];
        foreach (string name in names)
        {
            LicenceOf(spec, name);
        }
    }

    /// <summary>The sources that the manifest names for a run.</summary>
    /// <param name="spec">Has the licences that the user knows.</param>
    /// <param name="description">The settings of the run, as the manifest has them.</param>
    public static IReadOnlyList<DataSetSource> Of(DataSetSpec spec, string description)
    {
        JsonElement root = JsonElement.Parse(description);
        JsonElement model = root.GetProperty("model");
        List<DataSetSource> sources = [];
        Add("elevation model", Text(model, "product"), Text(model, "sha256_of_parts"));
        foreach (JsonElement kernel in root.GetProperty("kernels").EnumerateArray())
        {
            Add("kernel", Text(kernel, "name"), Text(kernel, "sha256"));
        }

        if (root.TryGetProperty("inputs", out JsonElement inputs))
        {
            foreach (JsonElement input in inputs.EnumerateArray())
            {
                Add(Text(input, "kind"), Text(input, "name"), Text(input, "sha256"));
            }
        }

        return sources;

        string Text(JsonElement element, string name) => element.GetProperty(name).GetString()!;

        void Add(string kind, string name, string sha256) =>
            sources.Add(new DataSetSource(WordsOf(kind), name, sha256, LicenceOf(spec, name)));
    }

    /// <summary>Canonical arguments of the frames of a run.</summary>
    /// <param name="description">The settings of the run, as the manifest has them.</param>
    public static string ArgumentsOf(string description) => JsonElement.Parse(description).GetProperty("arguments").GetString()!;

    /// <summary>A kind of inputs in plain words: "AlbedoMap" is "albedo map".</summary>
    private static string WordsOf(string kind) =>
        string.Concat(kind.Select(letter => char.IsUpper(letter) ? $" {char.ToLowerInvariant(letter)}" : $"{letter}")).Trim();

    private static string LicenceOf(DataSetSpec spec, string name) => spec.Licences.GetValueOrDefault(name) ?? Known(name)
        ?? throw new BadInputException(
            $"{spec.Path}: the licence of {name}, which the data set is made from, is not known. Say it below 'licences', e.g. "
                + $"{name}: public domain.");

    /// <summary>The licence of what msis itself fetches or makes; of several models joined by '+' that of all.</summary>
    private static string? Known(string name)
    {
        string[] parts = name.Split('+', StringSplitOptions.TrimEntries);
        if (parts.Length > 1)
        {
            string?[] licences = [.. parts.Select(Known).Distinct()];
            return licences.All(licence => licence is not null) ? string.Join("; ", licences) : null;
        }

        return name.EndsWith("_SYNTHETIC", StringComparison.Ordinal) ? Made
            : name is "bright" or "bright.csv" ? "CC0 1.0 (Open Source Bright Star Catalog)"
            : Array.Exists(OfNasa, start => name.StartsWith(start, StringComparison.OrdinalIgnoreCase)) ? Nasa
            : null;
    }

    /// <summary>Beginnings of the names of NASA's models, maps and kernels that the scripts fetch or kernels/ holds.</summary>
    private static readonly string[] OfNasa = ["LDEM_", "SLDEM", "moon_", "WAC_", "naif", "pck", "de4", "mar0", "jup", "mercury.tpc"];
}
