using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Settings.Specs;
using Msisf.Core.Layers;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>Reads the options of the program's own renderer.</summary>
internal static class NativeSettingsReader
{
    /// <summary>Reads and checks all options.</summary>
    /// <param name="map">The options of the map and of the band.</param>
    /// <param name="detector">The camera's detector; null without one.</param>
    /// <param name="scans">Whether the camera's rows have times of their own.</param>
    /// <param name="needsTruth">Whether the meta file needs ground truth, because its pixels lie on the terrain.</param>
    public static NativeSettings Read(OptionValues values, AlbedoSettings map, CameraFileDetector? detector, bool scans, bool needsTruth)
    {
        (string law, SortedDictionary<string, double> parameters) = ReflectanceText.Parse(NativeOptions.Reflectance.Read(values));
        double? albedo = NativeOptions.Albedo.ReadIfGiven(values);
        RefuseTwoBrightnesses(albedo, map);
        NavigationSettings? navigation = NavigationSettings.Read(values);
        LayerSet? layers = NativeOptions.Layers.ReadIfGiven(values) is { } names
            ? NativeOptions.Layers.NamedInErrors(() => Layers(names))
            : null;
        bool isAll = layers == LayerSet.All;
        if (detector is null)
        {
            LeaveOut(
                layer => layer.NeedsDetector, "needs a camera with a detector. Name a --camera file that has the section 'detector'.",
                ImageOptions.Camera);
        }

        if (navigation?.Craters is null)
        {
            LeaveOut(
                layer => layer.NeedsCraters, $"needs a catalogue of craters. Name one by {NavigationOptions.Craters.Name}.",
                NavigationOptions.Craters);
        }

        SkySettings? sky = SkySettings.Read(values);
        if (sky is not { IsDrawn: true })
        {
            LeaveOut(
                layer => layer.NeedsSky, $"needs something behind the ground. Add {SkyOptions.All.Name}, or leave the layer out.",
                SkyOptions.All);
        }

        IndirectLight? indirect = IndirectOptions.Read(values, scans);
        if (indirect is null)
        {
            LeaveOut(
                layer => layer.NeedsIndirect, $"is the light that the ground throws on ground. Add {IndirectOptions.Bounces.Name}.",
                IndirectOptions.Bounces);
        }

        navigation?.RefuseWithoutDerivatives(values, detector, indirect, scans);
        RefineSettings? refine = RefineSettings.Read(values);
        if (refine is null)
        {
            LeaveOut(
                layer => layer.NeedsInventedGround,
                $"needs invented ground. Give {NativeOptions.Refine.Name} with a seed, or leave the layer out.",
                NativeOptions.Refine);
        }

        if (layers is not null && (refine is not null || SurfaceOptions.Ldem.ReadAll(values).Count > 1))
        {
            layers = layers.OfSeveralModels();
        }
        else if (isAll)
        {
            layers = layers!.Without(layer => layer.NeedsModels);
        }

        double? exposure = Exposure(values, out bool findsExposure);
        GreyScale grey = NativeOptions.Exposure.Named(
            () => new GreyScale(
                exposure ?? (ReflectanceFactory.IsAbsolute(law, parameters.Keys)
                    ? NativeOptions.ExposureOfMoon
                    : NativeOptions.ExposureOfOtherLaws),
                NativeOptions.Transfer.Read(values)));
        (int subsamplesPerAxis, AdaptiveSampling? adaptive) = SamplesReader.Read(values, grey);
        return DetectorChoice.WithExposureTime(values, new NativeSettings
        {
            Render = new NativeRenderOptions
            {
                Reflectance = NativeOptions.Reflectance.NamedInErrors(
                    () => (albedo is null ? (OptionSpec)NativeOptions.Reflectance : NativeOptions.Albedo).Named(
                        () => ReflectanceFactory.Create(law, parameters, albedo, map.Band))),
                Sun = NativeOptions.Sun.Read(values),
                Normals = NativeOptions.Shading.Read(values),
                SubsamplesPerAxis = subsamplesPerAxis,
                Adaptive = adaptive,
                Indirect = indirect,
                KeepGroundTruth = needsTruth || layers is not null || navigation is not null,
            },
            ReflectanceText = parameters.Count == 0
                ? law
                : $"{law}:{string.Join(',', parameters.Select(pair => $"{pair.Key}={NumberSpec.TextOf(pair.Value)}"))}",
            HapkeMap = HapkeMap(values, law, map),
            Albedo = albedo,
            Grey = grey,
            FindsExposure = findsExposure && detector is null,
            BitDepth = NativeOptions.BitDepth.Read(values),
            Detector = detector,
            Refine = refine,
            Navigation = navigation,
            Sky = sky,
            Layers = layers,
            LayersFormat = NativeOptions.LayersFormat.Read(values),
            LayersPrecision = NativeOptions.LayersPrecision.Read(values),
            LayersCompression = NativeOptions.LayersCompression.Read(values),
        });

        // Takes the layers away that a frame has with an option only; one that is named is an error without it.
        void LeaveOut(Func<Layer, bool> needs, string reason, OptionSpec missing) =>
            layers = isAll || layers?.Layers.FirstOrDefault(needs) is not { } named
                ? layers?.Without(needs)
                : throw new UsageException($"--layers: {named.Name} {reason}").About(NativeOptions.Layers, missing);
    }

    /// <summary>The exposure that was given; null if none was, or if it is to be found.</summary>
    /// <exception cref="UsageException">It is not a number.</exception>
    private static double? Exposure(OptionValues values, out bool isFound)
    {
        string? text = NativeOptions.Exposure.ReadIfGiven(values);
        isFound = text is not null && ChoiceSpec.IsSame(text, NativeOptions.Automatic);
        return text is null || isFound ? null
            : NumberText.TryParse(text, out double exposure) ? exposure
            : throw new UsageException($"{NativeOptions.Exposure.Name}: {NumberText.ProblemWith(text)}, or {NativeOptions.Automatic}.")
                .About(NativeOptions.Exposure);
    }

    private static string? HapkeMap(OptionValues values, string law, AlbedoSettings map)
    {
        string? path = NativeOptions.HapkeMap.ReadIfGiven(values);
        if (path is not null && law != ReflectanceFactory.DefaultLaw)
        {
            throw NativeOptions.HapkeMap.Wrong(
                $"is for --reflectance moon; the law here is {law}. Leave one out.", NativeOptions.Reflectance);
        }

        return path is null || map.Band.Nanometres == HapkeMapFile.BandNanometres
            ? path
            : throw NativeOptions.HapkeMap.Wrong(
                $"holds the parameters at {HapkeMapFile.BandNanometres} nm, but --band is {map.Band.Nanometres}. Leave one out.",
                AlbedoOptions.Band);
    }

    private static void RefuseTwoBrightnesses(double? albedo, AlbedoSettings map)
    {
        if (albedo is not null && map.Maps.Count > 0)
        {
            throw new UsageException("--albedo and --albedo-map both set the brightness of the surface. Leave one out.")
                .About(NativeOptions.Albedo, AlbedoOptions.Map);
        }
    }

    private static LayerSet Layers(string names)
    {
        string? wrong = names.Split(',', StringSplitOptions.TrimEntries).FirstOrDefault(
            name => !NativeOptions.Layers.Words.Any(word => ChoiceSpec.IsSame(word, name)));
        return wrong is not null && NearestName.Question(wrong, NativeOptions.Layers.Words) is { Length: > 0 } question
            ? throw new UsageException($"{NativeOptions.Layers.Name} {names}: '{wrong}' is not a layer{question}")
            : LayerSet.Parse(names);
    }
}

/// <summary>The value of --reflectance, such as "hapke:w=0.3,b0=1.2".</summary>
internal static class ReflectanceText
{
    /// <summary>The law's name and its parameters, both in lower case.</summary>
    /// <exception cref="UsageException">A parameter has no number or is given twice, or the name resembles a law's.</exception>
    public static (string Law, SortedDictionary<string, double> Parameters) Parse(string text)
    {
        (string law, string[] given) = Split(text);
        SortedDictionary<string, double> parameters = new(StringComparer.Ordinal);
        foreach (string parameter in given)
        {
            string[] pair = Pair(parameter);
            if (pair.Length != 2 || !NumberText.TryParse(pair[1], out double value))
            {
                throw new UsageException($"--reflectance: '{parameter}' is not a parameter; "
                    + $"name=number is needed, as in hapke:w=0.3,b0=1.2.").About(NativeOptions.Reflectance);
            }

            if (!parameters.TryAdd(pair[0], value))
            {
                throw new UsageException(
                    $"--reflectance: the parameter {pair[0]} is given twice. Leave one out.").About(NativeOptions.Reflectance);
            }
        }

        return NativeOptions.Reflectance.Words.Contains(law) || NearestName.Question(
            law, NativeOptions.Reflectance.Words) is not { Length: > 0 } question
            ? (law, parameters)
            : throw new UsageException($"{NativeOptions.Reflectance.Name}: '{law}' is not a law{question}")
                .About(NativeOptions.Reflectance);
    }

    /// <summary>Whether a text, right or wrong, names a law with a brightness of its own, beside which no albedo can be given.</summary>
    public static bool IsAbsolute(string text)
    {
        (string law, string[] given) = Split(text);
        return ReflectanceFactory.IsAbsolute(law, given.Select(parameter => Pair(parameter)[0]));
    }

    private static (string Law, string[] Parameters) Split(string text)
    {
        string[] parts = text.ToLowerInvariant().Split(':', 2);
        return (parts[0].Trim(), parts.Length == 2 ? parts[1].Split(',') : []);
    }

    private static string[] Pair(string parameter) => parameter.Split('=', 2, StringSplitOptions.TrimEntries);
}

/// <summary>Reads the option --samples: a square number, or auto with an error.</summary>
internal static class SamplesReader
{
    /// <summary>The word for as many samples as an error takes.</summary>
    public const string Auto = "auto";

    private const int Max = NativeRenderOptions.MaxSubsamplesPerAxis * NativeRenderOptions.MaxSubsamplesPerAxis;

    /// <param name="grey">The grey levels in which the error is meant.</param>
    /// <returns>Samples along a pixel's edge, 1 with auto, and the sampling of auto, otherwise null.</returns>
    /// <exception cref="UsageException">The value is neither.</exception>
    public static (int SubsamplesPerAxis, AdaptiveSampling? Adaptive) Read(OptionValues values, GreyScale grey)
    {
        string text = NativeOptions.Samples.Read(values);
        string[] parts = text.Split(':', 2);
        return ChoiceSpec.IsSame(Auto, parts[0])
            ? (1, new AdaptiveSampling(parts.Length == 2 ? Error(parts[1]) : AdaptiveSampling.DefaultError, grey))
            : (SubsamplesPerAxis(text), null);
    }

    /// <summary>The option's value as it is written in a frame's arguments.</summary>
    public static string TextOf(NativeRenderOptions options) => options.Adaptive is { } adaptive
        ? $"{Auto}:{NumberSpec.TextOf(adaptive.Error)}"
        : (options.SubsamplesPerAxis * options.SubsamplesPerAxis).ToString(CultureInfo.InvariantCulture);

    private static double Error(string text)
    {
        NumberRange range = new(AdaptiveSampling.MinError, AdaptiveSampling.MaxError);
        return NumberText.TryParse(text, out double error) && range.Contains(error)
            ? error
            : throw new UsageException(
                $"--samples: the error of auto is '{text}'; levels of 255 in the range {range} are needed, as in auto:0.4.")
                .About(NativeOptions.Samples);
    }

    private static int SubsamplesPerAxis(string text)
    {
        if (!int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int samples) || samples is < 1 or > Max)
        {
            throw NativeOptions.Samples.Wrong(
                $"is '{text}'; a square number from 1 to {Max.ToString(CultureInfo.InvariantCulture)} or auto[:ERROR] is needed.");
        }

        int perAxis = (int)Math.Sqrt(samples); // exact for numbers as small as these
        return perAxis * perAxis == samples
            ? perAxis
            : throw NativeOptions.Samples.Wrong(
                $"is {samples}; the samples form a square grid, so a square number is needed: {perAxis * perAxis} or "
                    + $"{(perAxis + 1) * (perAxis + 1)}.");
    }
}
