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
    /// <exception cref="MsisfException">A value is wrong.</exception>
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
        layers = NavigationSettings.LayersOf(DetectorChoice.LayersOf(layers, detector), isAll, navigation);
        IndirectLight? indirect = IndirectOptions.Read(values, scans);
        layers = IndirectOptions.LayersOf(layers, isAll, indirect);
        RefineSettings? refine = RefineSettings.Read(values);
        layers = RefineSettings.LayersOf(layers, isAll, refine);
        if (layers is not null && (refine is not null || SurfaceOptions.Ldem.ReadAll(values).Count > 1))
        {
            layers = layers.OfSeveralModels();
        }
        else if (isAll)
        {
            layers = layers!.Without(layer => layer.NeedsModels);
        }

        GreyScale grey = NativeOptions.Exposure.Named(
            () => new GreyScale(
                NativeOptions.Exposure.ReadIfGiven(values) ?? (ReflectanceFactory.IsAbsolute(law, parameters.Keys)
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
            BitDepth = NativeOptions.BitDepth.Read(values),
            Detector = detector,
            Refine = refine,
            Navigation = navigation,
            Layers = layers,
            LayersFormat = NativeOptions.LayersFormat.Read(values),
            LayersPrecision = NativeOptions.LayersPrecision.Read(values),
            LayersCompression = NativeOptions.LayersCompression.Read(values),
        });
    }

    private static string? HapkeMap(OptionValues values, string law, AlbedoSettings map)
    {
        string? path = NativeOptions.HapkeMap.ReadIfGiven(values);
        if (path is not null && law != ReflectanceFactory.DefaultLaw)
        {
            throw new UsageException($"--hapke-map is for --reflectance moon; the law here is {law}. Leave one out.")
                .About(NativeOptions.HapkeMap, NativeOptions.Reflectance);
        }

        return path is null || map.Band.Nanometres == HapkeMapFile.BandNanometres
            ? path
            : throw new UsageException(
                $"--hapke-map holds the parameters at {HapkeMapFile.BandNanometres} nm, but --band is {map.Band.Nanometres}. "
                    + $"Leave one out.")
                .About(NativeOptions.HapkeMap, AlbedoOptions.Band);
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
            ? throw new UsageException($"{NativeOptions.Layers.Name} {names}: '{wrong}' is no layer{question}")
            : LayerSet.Parse(names);
    }
}
