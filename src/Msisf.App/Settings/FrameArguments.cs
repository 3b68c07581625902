using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>
/// The canonical arguments of a frame: all arguments that determine its content, in a fixed order, however the user gave them
/// (configuration file, batch file or orbit). They are the options that decide bytes (<see cref="DecidesBytes"/>).
/// </summary>
internal static class FrameArguments
{
    /// <summary>The order, which the manifests of older versions hold; options that are not named here come behind.</summary>
    private static readonly OptionSpec[] Order =
    [
        ImageOptions.Camera, ImageOptions.FieldOfView, ImageOptions.Width, ImageOptions.Height,
        OutputOptions.GridHorizontal, OutputOptions.GridVertical, OutputOptions.Surface,
        SurfaceOptions.Ldem, SurfaceOptions.Resolution, SurfaceOptions.Body, SurfaceOptions.LevelOfDetailError,
        SurfaceOptions.LevelOfDetail,
        LightOptions.IgnoreSun, LightOptions.Ephemeris, LightOptions.Aberration, OutputOptions.Annotation, RendererOptions.Renderer,
        AlbedoOptions.Map, AlbedoOptions.Checksum, AlbedoOptions.Properties, AlbedoOptions.Band,
        NativeOptions.Reflectance, NativeOptions.HapkeMap, NativeOptions.Albedo, NativeOptions.Sun, NativeOptions.Samples,
        NativeOptions.Shading, NativeOptions.Exposure, NativeOptions.Transfer, NativeOptions.BitDepth,
    ];

    private static readonly OptionSpec[] Options =
        [.. Order.Concat(CommandTable.OptionsOfRun.Except(Order)).Where(option => option.Role is DecidesBytes)];

    /// <summary>The arguments of the settings, without the state.</summary>
    /// <param name="engine">The ephemeris engine for the Sun's position; null if none is used.</param>
    /// <param name="map">The map of the Moon's reflectance; null if none is used.</param>
    public static string OfSettings(RenderSettings settings, EphemerisChoice? engine, InputFile? map = null)
    {
        FrameContent frame = new(settings, engine, map);
        return string.Join(' ', Options.SelectMany(option => option.Role is DecidesBytes role && role.Value(frame) is { } value
            && !(role.LeavesOutDefault && option.TextOf(value) == option.DefaultValue)
                ? Words(option, value)
                : []));
    }

    /// <summary>The canonical arguments of one frame: its state and the settings.</summary>
    /// <param name="settings">The result of <see cref="OfSettings"/>.</param>
    public static string Of(SpacecraftState state, string settings)
    {
        string[] words =
        [
            CameraOptions.FixedState.Name, State(state.Time, (state with { Motion = null }).ToNumbers()),
            .. state.Motion is { } motion ? (string[])[CameraOptions.Motion.Name, List(motion.ToNumbers())] : [],
            .. state.SunPositionBodyFixed is { } sun ? (string[])[LightOptions.SunPosition.Name, List([sun.X, sun.Y, sun.Z])] : [],
            .. state.Path is { States.Count: > 1 } path ? (string[])[ScanOptions.Trajectory.Name, $"#{path.Digest()}"] : [],
            settings,
            .. state.Sky is { } sky
                ? (string[])[MissionOptions.OfGround.Name, MissionOptions.OfGround.WordOf(sky.OfGround)]
                : [],
            .. state.Flow is { } flow ? (string[])[NavigationOptions.Flow.Name, State(flow.Time, flow.ToNumbers())] : [],
            .. state.ExposureFactor is { } factor
                ? (string[])[NativeOptions.ExposureFactor.Name, NumberSpec.TextOf(factor)]
                : [],
            .. state.Noise is { } noise ? (string[])[NativeOptions.NoiseSeed.Name, NoiseSeedText.Of(noise)] : [],
        ];
        return string.Join(' ', words);
    }

    private static string List(double[] numbers) => $"'{{{string.Join(',', numbers.Select(NumberSpec.TextOf))}}}'";

    private static string State(Instant time, double[] numbers) =>
        $"'{{{string.Join(',', [TimeText.Of(time), .. numbers.Skip(1).Select(NumberSpec.TextOf)])}}}'";

    private static IEnumerable<string> Words(OptionSpec option, object value) => (option, value) switch
    {
        (FlagSpec, _) => value is true ? [option.Name] : [],
        ({ MayBeRepeated: true }, IEnumerable<string> each) => each.SelectMany(text => (string[])[option.Name, Quoted(text)]),
        (_, IEnumerable<string> list) => list.Any() ? [option.Name, QuotedList(option, list)] : [],
        _ => option.TextOf(value) is { Length: > 0 } text ? [option.Name, Quoted(text)] : [],
    };

    private static string QuotedList(OptionSpec option, IEnumerable<string> values) =>
        option.ListSeparator == " " ? $"'{string.Join(' ', values)}'" : Quoted(string.Join(option.ListSeparator, values));

    private static string Quoted(string text) => text.Contains(' ', StringComparison.Ordinal) ? $"'{text}'" : text;
}
