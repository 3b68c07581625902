using Msisf.Adapters.Input;
using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.DataSets;

/// <summary>Reads the file of a data set.</summary>
internal sealed class DataSetFile
{
    /// <summary>Formats of the index beside CSV.</summary>
    public static readonly string[] IndexFormats = ["csv", "coco", "tum", "kitti"];

    private const int MostImages = 10_000_000;
    private const string OptionsKey = "options";
    private const string LicencesKey = "licences";

    private static readonly string[] Keys =
    [
        "name", "description", "licence", "count", "seed", "noise-seed", "sampling", "index", Quantity.States, Quantity.Pair, "accept",
        SplitSection.Key, LicencesKey, OptionsKey,
    ];

    private static readonly string[] AcceptKeys = ["ground", "lit", "sun-elevation"];

    /// <summary>Options that a data set has if its file does not say otherwise.</summary>
    private static readonly (OptionSpec Option, string Text)[] Defaults =
    [
        (RendererOptions.Renderer, "native"), (OutputOptions.Name, "{step:000000}"),
        (NativeOptions.LayersFormat, "npy"), (NativeOptions.LayersPrecision, "single"),
    ];

    private readonly string _path;
    private readonly IReadOnlyList<ConfigEntry> _entries;
    private readonly SettingsSection _file;

    private DataSetFile(string path, IReadOnlyList<ConfigEntry> entries)
    {
        (_path, _entries) = (path, entries);
        _file = new SettingsSection(path, "a data set", (1, 1), entries, Keys);
    }

    /// <summary>Reads a file.</summary>
    /// <param name="line">The options of the command line, which go before those of the file.</param>
    /// <exception cref="MsisfException">What is wrong in it, by file, line and column.</exception>
    public static DataSetSpec Read(string path, OptionValues line, ProgramHost host)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException(Directory.Exists(path)
                ? $"{path}: is a folder; the YAML file of a data set is needed."
                : $"{path}: there is no such file. The YAML file of a data set is needed (docs/data-sets.md).");
        }

        IReadOnlyList<ConfigEntry> entries = FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            return ConfigFileReader.Read(stream, path, levels: 1);
        });
        return new DataSetFile(path, entries).Read(line, host);
    }

    private DataSetSpec Read(OptionValues line, ProgramHost host)
    {
        ulong seed = Seed("seed") ?? 1;
        (IReadOnlyList<Split> splits, IReadOnlyList<int> order) = SplitSection.Read(
            _file, Section(SplitSection.Key, "the splits", KeysBelow(SplitSection.Key)), States(), KeysBelow(SplitSection.Key),
            _file.Whole("count", 1, MostImages) ?? throw _file.Missing("count", "how many images, or pairs, it has"));
        return new DataSetSpec
        {
            Path = _path,
            Sha256 = FileHash.Sha256Of(_path),
            Name = _file.Text("name") ?? Path.GetFileNameWithoutExtension(_path),
            Description = _file.Text("description"),
            Licence = _file.Text("licence"),
            Seed = seed,
            NoiseSeed = Seed("noise-seed") ?? seed,
            IsEven = _file.Word("sampling", ["kronecker", "random"]) != "random",
            Distributions = Distributions(),
            Splits = splits,
            Order = order,
            HasPairs = _file.Has(Quantity.Pair),
            Accept = Accept(),
            Indexes = Indexes(),
            Licences = KeysBelow(LicencesKey).ToDictionary(
                key => key, key => Section(LicencesKey, "the licences", KeysBelow(LicencesKey))!.Text(key)!, StringComparer.Ordinal),
            Options = Options(line, host),
        };
    }

    private SettingsSection? Section(string key, string what, IReadOnlyList<string> keys) => _file.Section(key, what, keys);

    private string[] KeysBelow(string key) =>
        [.. _entries.FirstOrDefault(entry => entry.Key == key)?.Entries?.Select(entry => entry.Key) ?? []];

    private static string[] KeysOf(string section) =>
        [.. Quantity.All.Where(quantity => quantity.Section == section).Select(quantity => quantity.Key)];

    private SettingsSection States() =>
        Section(Quantity.States, "the states", ["latitude", "longitude", .. KeysOf(Quantity.States)])
            ?? throw _file.Missing(Quantity.States, "how the cameras' states are distributed");

    private ulong? Seed(string key) => _file.Text(key) is not { } text ? null
        : ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong number)
            ? number
            : throw _file.Wrong(key, $"'{key}' is {NumberText.Shown(text)}; a whole number from 0 on is needed");

    private string[] Indexes()
    {
        IReadOnlyList<string> formats = _file.Texts("index") ?? [];
        return formats.FirstOrDefault(format => !IndexFormats.Contains(format)) is { } wrong
            ? throw _file.Wrong("index", $"{NumberText.Shown(wrong)} is not a format; some of {string.Join(", ", IndexFormats)} are needed")
            : [.. formats.Where(format => format != IndexFormats[0]).Distinct()];
    }

    private Dictionary<Quantity, Distribution> Distributions()
    {
        SettingsSection states = States();
        SettingsSection? pair = Section(Quantity.Pair, "a pair", KeysOf(Quantity.Pair));
        Dictionary<Quantity, Distribution> read = [];
        foreach (Quantity quantity in Quantity.All)
        {
            SettingsSection? section = quantity.Section == Quantity.Pair ? pair : states;
            if (section is null)
            {
                continue;
            }

            if (DistributionOf(section, quantity) is { } distribution)
            {
                read.Add(quantity, distribution);
            }
        }

        if (!read.ContainsKey(Quantity.Altitude))
        {
            throw states.Missing(Quantity.Altitude.Key, "m over the terrain below the camera");
        }

        if (read.ContainsKey(Quantity.SunElevation))
        {
            read.TryAdd(Quantity.Time, Distribution.Of(TimeText.Parse("2026-01-01T00:00:00Z").Mjd));
        }
        else
        {
            read.Remove(Quantity.SunAzimuth);
            if (states.Has(Quantity.SunAzimuth.Key))
            {
                throw states.Wrong(
                    Quantity.SunAzimuth.Key, "'sun-azimuth' is of no use without 'sun-elevation'. Add that, or leave it out");
            }
        }

        return read.ContainsKey(Quantity.Time)
            ? read
            : throw states.Missing(
                Quantity.SunElevation.Key,
                "degrees over the horizon below the camera, where the Sun is put; or 'time', at which it is where it is");
    }

    private static Distribution? DistributionOf(SettingsSection section, Quantity quantity)
    {
        if (section.Texts(quantity.Key) is not { } values)
        {
            return quantity.Default;
        }

        try
        {
            Distribution distribution = Distribution.Parse(
                values,
                text => quantity == Quantity.Time ? TimeText.Parse(text).Mjd : NumberOf(text));
            return distribution.Min >= quantity.Least && distribution.Max <= quantity.Greatest
                ? distribution
                : throw new BadInputException(Invariant(
                    $"{distribution} goes beyond what is possible: {quantity.Least:R} to {quantity.Greatest:R} {quantity.Unit}")
                    .TrimEnd());
        }
        catch (BadInputException exception)
        {
            throw section.Wrong(quantity.Key, $"'{quantity.Key}': {exception.Message.TrimEnd('.')}");
        }
    }

    private static double NumberOf(string text) =>
        NumberText.TryParse(text, out double number) ? number : throw new BadInputException(NumberText.ProblemWith(text));

    private Conditions Accept()
    {
        SettingsSection? section = Section("accept", "the conditions", AcceptKeys);
        double[]? elevation = section?.Numbers("sun-elevation", 2, 2);
        return elevation is [double min, double max] && !(min < max)
            ? throw section!.Wrong("sun-elevation", "the first limit is not below the second. Swap them")
            : new Conditions(Part("ground"), Part("lit"), elevation is null ? null : (elevation[0], elevation[1]));

        double Part(string key) => section?.Number(key) switch
        {
            null => 0.0,
            >= 0.0 and <= 1.0 and double part => part,
            _ => throw section.Wrong(key, $"'{key}' is {section.Text(key)}; a part from 0 to 1 is needed"),
        };
    }

    /// <summary>The options of the run: those of the command line, of the file, and the defaults of data sets.</summary>
    private OptionValues Options(OptionValues line, ProgramHost host)
    {
        IReadOnlyList<ConfigEntry> entries = _entries.FirstOrDefault(entry => entry.Key == OptionsKey) is not { } section
            ? []
            : section.Entries ?? throw _file.Wrong(
                OptionsKey, "'options' is a section: put the options below it, each in a line of its own and indented");
        Dictionary<string, OptionValue> values = new ConfigFiles(host).Values(_path, entries, isOfRun: true)
            .Where(value => !line.IsGiven(value.Option))
            .ToDictionary(value => value.Option.Name, value => value.ToOptionValue(), StringComparer.Ordinal);
        if (values.Keys.FirstOrDefault(name => CommandTable.OptionsOfRun.All(option => option.Name != name)) is { } foreign)
        {
            throw _file.Wrong(OptionsKey, $"'{foreign[2..]}' is an option of another command. Leave it out");
        }

        // A camera may be a preset's name too, so configuration files do not treat it as a path.
        string folder = Path.GetDirectoryName(Path.GetFullPath(_path))!;
        if (values.TryGetValue(ImageOptions.Camera.Name, out OptionValue? camera)
            && Path.GetFullPath(camera.Words[0], folder) is var cameraFile && File.Exists(cameraFile))
        {
            values[ImageOptions.Camera.Name] = camera with { Words = [cameraFile] };
        }

        if (_file.Has(Quantity.Pair))
        {
            values.TryAdd(NavigationOptions.Flow.Name, new OptionValue([NavigationOptions.PairedFrame]));
            values.TryAdd(NavigationOptions.FlowFormat.Name, new OptionValue(["npy"]));
        }

        if (!line.IsGiven(RendererOptions.Renderer))
        {
            values.TryAdd(RendererOptions.Renderer.Name, new OptionValue([RendererOptions.Renderer.WordOf(RendererKind.Native)]));
        }

        OptionValues looked = LookOptions.Behind(line.With(values));
        values.Remove(LookOptions.Look.Name);
        foreach (OptionSpec option in LookOptions.Options.Where(option => !line.IsGiven(option)))
        {
            if (looked.Words(option) is { } words)
            {
                values.TryAdd(option.Name, new OptionValue(words));
            }
        }

        bool hasLayers = values.ContainsKey(NativeOptions.Layers.Name);
        foreach ((OptionSpec option, string text) in Defaults.Where(entry => hasLayers || !NativeOptions.OfLayers.Contains(entry.Option)))
        {
            values.TryAdd(option.Name, new OptionValue([text]));
        }

        OptionValues all = line.With(values);
        return RendererOptions.Renderer.Read(all) == RendererKind.Native
            ? all
            : throw new UsageException("a data set is drawn by the native renderer. Leave the renderer out.")
                .About(RendererOptions.Renderer);
    }
}
