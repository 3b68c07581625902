using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;

namespace Msisf.App.Settings;

/// <summary>
/// The canonical arguments of a frame: all arguments that determine its content, in a fixed order, however the user gave them
/// (configuration file, batch file or orbit). Arguments for paths and for the course of the run are omitted, because they do not change the
/// content.
/// </summary>
internal static class FrameArguments
{
    /// <summary>The arguments of the settings, without the state.</summary>
    /// <param name="settings">Settings of the run.</param>
    /// <param name="engine">The ephemeris engine for the Sun's position; null if none is used.</param>
    /// <param name="map">The map of the Moon's reflectance; null if none is used.</param>
    public static string OfSettings(RenderSettings settings, EphemerisChoice? engine, InputFile? map = null)
    {
        List<string> words =
        [
            .. OfImage(settings),
            OutputOptions.GridHorizontal.Name, Text(settings.GridHorizontal),
            OutputOptions.GridVertical.Name, Text(settings.GridVertical),
            .. OutputOptions.Surface.Words(settings.Surface),
            .. OfModels(settings),
            .. settings.Body.IsMoon ? [] : (string[])[.. SurfaceOptions.Body.Words(settings.Body.NaifNumber)],
            .. settings.LevelOfDetailError is double error
                ? [SurfaceOptions.LevelOfDetailError.Name, NumberSpec.TextOf(error)]
                : SurfaceOptions.LevelOfDetail.Words(true),
            .. settings.IgnoreSun
                ? [LightOptions.IgnoreSun.Name]
                : (string[])[.. LightOptions.Ephemeris.Words(
                    engine ?? EphemerisChoice.BuiltIn), .. LightOptions.Aberration.Words(settings.Aberration)],
        ];
        if (settings.Annotate)
        {
            words.Add(OutputOptions.Annotation.Name);
        }

        words.AddRange(RendererOptions.Renderer.Words(settings.Renderer));
        words.AddRange(OfAlbedo(settings, map));
        if (settings.Renderer == RendererKind.Native)
        {
            words.AddRange(OfNative(settings.Native));
        }
        else if (settings.PovOptions.Count > 0)
        {
            words.AddRange([PovOptions.MoreOptions.Name, $"'{string.Join(' ', settings.PovOptions)}'"]);
        }

        return string.Join(' ', words);
    }

    /// <summary>The canonical arguments of one frame: its state and the settings.</summary>
    /// <param name="state">State of the frame.</param>
    /// <param name="settings">The result of <see cref="OfSettings"/>.</param>
    public static string Of(SpacecraftState state, string settings)
    {
        string[] words =
        [
            CameraOptions.FixedState.Name, List((state with { Motion = null }).ToNumbers()),
            .. state.Motion is { } motion ? (string[])[CameraOptions.Motion.Name, List(motion.ToNumbers())] : [],
            settings,
            .. state.Noise is { } noise ? (string[])[NativeOptions.NoiseSeed.Name, NoiseSeedText.Of(noise)] : [],
        ];
        return string.Join(' ', words);
    }

    /// <summary>One model has a resolution and nothing else: its name is no part of the content. Several are named, in any order.</summary>
    private static IEnumerable<string> OfModels(RenderSettings settings)
    {
        if (settings.Ldem.Count > 1)
        {
            return settings.Ldem.Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal)
                .SelectMany(name => (string[])[SurfaceOptions.Ldem.Name, Quoted(name)]);
        }

        return settings.Resolution.PixelsPerDegree is { } resolution ? [SurfaceOptions.Resolution.Name, Text(resolution)] : [];
    }

    private static string List(double[] numbers) => $"'{{{string.Join(',', numbers.Select(NumberSpec.TextOf))}}}'";

    /// <summary>
    /// The map with its properties, and the band where a map, the law or the radiance depends on it. A frame without a map says so if an
    /// installed one would be used.
    /// </summary>
    private static List<string> OfAlbedo(RenderSettings settings, InputFile? map)
    {
        bool isMoon = settings.Renderer == RendererKind.Native && settings.Native.ReflectanceText == ReflectanceFactory.DefaultLaw;
        bool hasRadiance = settings.Renderer == RendererKind.Native
            && settings.Native.Layers?.Layers.Any(layer => layer.Name == "radiance") == true;
        List<string> words = [];
        if (map is not null)
        {
            words.AddRange([AlbedoOptions.Map.Name, Quoted(map.Name), AlbedoOptions.Checksum.Name, map.Sha256]);
            if (settings.Albedo.Properties.ToString() is { Length: > 0 } properties)
            {
                words.AddRange([AlbedoOptions.Properties.Name, properties]);
            }
        }
        else if (isMoon)
        {
            words.AddRange([AlbedoOptions.Map.Name, AlbedoOptions.NoMap]);
        }

        if (map is not null || isMoon || hasRadiance)
        {
            words.AddRange(AlbedoOptions.Band.Words(settings.Albedo.Band.Nanometres));
        }

        return words;
    }

    private static IEnumerable<string> OfImage(RenderSettings settings) => settings.Camera is { } camera
        ?
        [
            ImageOptions.Camera.Name, Quoted(CameraChoice.TextOf(camera)),
            .. camera.AddedWidth is int width ? (string[])[ImageOptions.Width.Name, Text(width)] : [],
            .. camera.AddedHeight is int height ? (string[])[ImageOptions.Height.Name, Text(height)] : [],
        ]
        :
        [
            ImageOptions.FieldOfView.Name, NumberSpec.TextOf(settings.FieldOfViewDegrees),
            ImageOptions.Width.Name, Text(settings.Width),
            ImageOptions.Height.Name, Text(settings.Height),
        ];

    private static string Quoted(string text) => text.Contains(' ', StringComparison.Ordinal) ? $"'{text}'" : text;

    private static IEnumerable<string> OfNative(NativeSettings native) =>
    [
        NativeOptions.Reflectance.Name, native.ReflectanceText,
        .. native.HapkeMap is { } hapkeMap ? (string[])[NativeOptions.HapkeMap.Name, Quoted(Path.GetFileName(hapkeMap))] : [],
        .. native.Albedo is double albedo ? (string[])[NativeOptions.Albedo.Name, NumberSpec.TextOf(albedo)] : [],
        .. NativeOptions.Sun.Words(native.Render.Sun),
        NativeOptions.Samples.Name, SamplesReader.TextOf(native.Render),
        .. NativeOptions.Shading.Words(native.Render.Normals),
        NativeOptions.Exposure.Name, NumberSpec.TextOf(native.Grey.Exposure),
        .. NativeOptions.Transfer.Words(native.Grey.Transfer),
        .. NativeOptions.BitDepth.Words(native.BitDepth),
        .. native.ExposureTime is double seconds ? (string[])[NativeOptions.ExposureTime.Name, NumberSpec.TextOf(seconds)] : [],
        .. native.Refine is { } refine
            ? (string[])
            [
                NativeOptions.Refine.Name, refine.Seed.ToString(CultureInfo.InvariantCulture),
                NativeOptions.RefineCell.Name, NumberSpec.TextOf(refine.Cell),
            ]
            : [],
        .. native.Layers is null
            ? []
            : (string[])
            [
                NativeOptions.Layers.Name, string.Join(',', native.Layers.Layers.Select(layer => layer.Name)),
                .. NativeOptions.LayersFormat.Words(native.LayersFormat),
                .. UnlessDefault(NativeOptions.LayersPrecision, native.LayersPrecision),
                .. UnlessDefault(NativeOptions.LayersCompression, native.LayersCompression),
            ],
    ];

    /// <summary>An option that is newer than the manifest: frames made before it are those of its default.</summary>
    private static string[] UnlessDefault<T>(ChoiceSpec<T> option, T value)
        where T : struct =>
        value.Equals(option.Default) ? [] : option.Words(value);

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
}
