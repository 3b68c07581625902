using System.CommandLine;
using System.Globalization;
using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Layers;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.Cli.Options;

/// <summary>Turns the text of the native renderer's options into checked values.</summary>
internal sealed class NativeSettingsReader
{
    private readonly ParseResult _line;
    private readonly NativeOptions _options;

    public NativeSettingsReader(ParseResult line, NativeOptions options)
    {
        _line = line;
        _options = options;
    }

    /// <summary>Who draws.</summary>
    public RendererKind Renderer() => Choice(_options.Renderer, [("povray", RendererKind.PovRay), ("native", RendererKind.Native)]);

    /// <summary>Reads all.</summary>
    /// <param name="needsTruth">The meta file wants the terrain.</param>
    public NativeSettings Read(bool needsTruth)
    {
        (string law, SortedDictionary<string, double> parameters) = Reflectance();
        double? albedo = Number(_options.Albedo);
        LayerSet? layers = Text(_options.Layers) is string names ? LayerSet.Parse(names) : null;
        return new NativeSettings
        {
            Render = new NativeRenderOptions
            {
                Reflectance = OptionText.Named(
                    albedo is null ? _options.Reflectance : _options.Albedo, () => ReflectanceFactory.Create(law, parameters, albedo)),
                Sun = Choice(_options.Sun, [("point", SunModel.Point), ("disc", SunModel.Disc)]),
                Normals = Choice(_options.Shading, [("facet", NormalModel.Facet), ("smooth", NormalModel.Smooth)]),
                SubsamplesPerAxis = SubsamplesPerAxis(),
                KeepGroundTruth = needsTruth || layers is not null,
            },
            ReflectanceText = parameters.Count == 0
                ? law
                : $"{law}:{string.Join(',', parameters.Select(
                    pair => string.Create(CultureInfo.InvariantCulture, $"{pair.Key}={pair.Value:R}")))}",
            Albedo = albedo,
            Grey = OptionText.Named(_options.Exposure, () => new GreyScale(
                Number(_options.Exposure) ?? 1.0,
                Choice(_options.Transfer, [("srgb", GreyTransfer.Srgb), ("linear", GreyTransfer.Linear)]))),
            BitDepth = Choice(_options.BitDepth, [("8", 8), ("16", 16)]),
            Layers = layers,
            LayersFormat = Choice(_options.LayersFormat, [("fits", LayersFormat.Fits), ("npy", LayersFormat.Npy)]),
        };
    }

    private int SubsamplesPerAxis()
    {
        if (Text(_options.Samples) is not string text)
        {
            return 1;
        }

        const int Most = NativeRenderOptions.MaxSubsamplesPerAxis;
        int samples = OptionText.WholeNumber(_options.Samples, text, 1, Most * Most);
        int across = (int)Math.Sqrt(samples); // exact for numbers as small as these
        return across * across == samples
            ? across
            : throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"--samples is {samples}; the samples form a square grid, so a square number is needed: "
                    + $"{across * across} or {(across + 1) * (across + 1)}."));
    }

    /// <summary>"hapke:w=0.3,b0=1.2": the law, and its parameters by name.</summary>
    private (string Law, SortedDictionary<string, double> Parameters) Reflectance()
    {
        string[] parts = (Text(_options.Reflectance) ?? "lambert").Split(':', 2);
        SortedDictionary<string, double> parameters = new(StringComparer.Ordinal);
        foreach (string parameter in parts.Length == 2 ? parts[1].Split(',') : [])
        {
            string[] pair = parameter.Split('=', 2, StringSplitOptions.TrimEntries);
            if (pair.Length != 2 || !NumberText.TryParse(pair[1], out double value))
            {
                throw new BadInputException(
                    $"--reflectance: '{parameter}' is no parameter; name=number is needed, as in hapke:w=0.3,b0=1.2.");
            }

            if (!parameters.TryAdd(pair[0], value))
            {
                throw new BadInputException($"--reflectance: the parameter {pair[0]} is given twice. Leave one out.");
            }
        }

        return (parts[0].Trim(), parameters);
    }

    private string? Text(Option<string?> option) => _line.GetValue(option);

    private double? Number(Option<string?> option) => Text(option) is string text ? OptionText.Number(option, text) : null;

    /// <summary>The first choice is the default.</summary>
    private T Choice<T>(Option<string?> option, IReadOnlyList<(string Word, T Value)> choices) =>
        Text(option) is string text ? OptionText.Choice(option, text, choices) : choices[0].Value;
}
