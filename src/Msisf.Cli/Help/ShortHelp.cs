using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Help;

/// <summary>The first page of the program's help: the options that most calls need, by task, and the topics that have the others.</summary>
internal static class ShortHelp
{
    /// <summary>Word behind --help that asks for all options.</summary>
    public const string All = "all";

    /// <summary>The options of each task, with their values and what they say in a line.</summary>
    public static IReadOnlyList<(string Task, IReadOnlyList<(OptionSpec Option, string Value, string About)> Options)> Tasks { get; } =
    [
        ("Camera",
        [
            (PointingOptions.Position, "PLACE,HEIGHT", "over LAT,LON or a name, m: Tycho,80000"),
            (PointingOptions.LookAt, "PLACE", "what it looks at (default: straight down)"),
            (CameraOptions.FixedState, "STATE", "one state in numbers"),
            (CameraOptions.BatchFile, "FILE", "many states or places, one a line"),
            (CameraOptions.KeplerSet, "ELEMENTS", "an orbit, with --epoch"),
            (ImageOptions.FieldOfView, "DEGREES", "horizontal field of view"),
            (ImageOptions.Width, "PX", "image size, with --height"),
            (ImageOptions.Camera, "FILE|PRESET", "lens and detector (msis cameras lists presets)"),
        ]),
        ("Time and light",
        [
            (CameraOptions.Time, "TIME", "UTC: 2010-04-24T00:00:00Z, or an MJD"),
            (CameraOptions.TimeInterval, "[START:STEP:END]", "a series of times"),
            (LightOptions.IgnoreSun, "", "light from the camera"),
        ]),
        ("Ground and picture",
        [
            (LookOptions.Look, "thesis|truth|photo", "several options at once"),
            (RendererOptions.Renderer, "native", "without POV-Ray"),
            (NativeOptions.Samples, "N|auto", "antialiasing"),
            (NativeOptions.Shading, "smooth", "interpolated normals"),
            (NativeOptions.Reflectance, "LAW", "law of reflectance"),
            (SurfaceOptions.Resolution, "N", "elevation model of N pixels a degree"),
            (SurfaceOptions.Ldem, "PATH", "another one: global, polar, or GeoTIFF"),
            (NativeOptions.Refine, "SEED", "invent detail below the model"),
        ]),
        ("Files",
        [
            (OutputOptions.Folder, "DIR", "where they go"),
            (OutputOptions.Surface, "terrain", "the meta file's pixels on the terrain"),
            (NativeOptions.Layers, "LIST|all", "truth of each pixel, as FITS or NumPy"),
            (MapOptions.Map, "MAP", "GeoTIFFs on a map: orthographic,1000"),
            (NavigationOptions.Craters, "FILE", "a catalogue's craters as ellipses"),
            (DryRunOptions.DryRun, "", "only say what the images would show"),
        ]),
    ];

    /// <summary>The topics of msis help TOPIC, with the groups of options that each has.</summary>
    public static IReadOnlyDictionary<string, Func<IEnumerable<OptionGroup>>> Topics { get; } =
        new Dictionary<string, Func<IEnumerable<OptionGroup>>>
        {
            ["camera"] = () => [CameraOptions.Group, ImageOptions.Group],
            ["light"] = () => [LightOptions.Group, AlbedoOptions.Group],
            ["elevation"] = () => [SurfaceOptions.Group],
            ["renderer"] = () => [RendererOptions.Group, NativeOptions.Group, SkyOptions.Group, PovOptions.Group],
            ["outputs"] = () => [OutputOptions.Group, NavigationOptions.Group],
            ["missions"] = () => [new OptionGroup("Missions", [.. MissionOptions.All, .. ScanOptions.OfTrajectory, LightOptions.Kernels])],
            ["series"] = () => [RunOptions.Group, new OptionGroup("Pieces", [CutOptions.Pieces, CutOptions.FramesPerPiece])],
        };
}
