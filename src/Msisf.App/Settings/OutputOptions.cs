using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;

namespace Msisf.App.Settings;

/// <summary>The options of the output files, except those of a single renderer.</summary>
internal static class OutputOptions
{
    /// <summary>Default pattern of the file names, as in the thesis.</summary>
    public const string DefaultName = "MoonSurfIllumSim_step_{step:00000}";

    public static PathSpec Folder { get; } = new("--output-dir", OptionRole.HowItRuns, PathKind.Folder, "Folder of the outputs")
    {
        Aliases = ["-o"],
        Default = "output",
        DefaultNote = "./output",
    };

    public static TextSpec Name { get; } = new(
        "--output-name", OptionRole.HowItRuns, "PATTERN",
        "File names without extension; {step}, {step:00000}, {mjd} and {mjd:0.000} stand for the image's number and time")
    {
        Default = DefaultName,
    };

    public static WholeNumberSpec Grid { get; } = new(
        "--grid", DecidesBytes.ByOthers, "PX", 1, int.MaxValue, "Spacing of the pixels that the meta file lists, both ways")
    {
        Aliases = ["-g"],
        Default = PixelGrid.DefaultSpacing,
    };

    public static WholeNumberSpec GridHorizontal { get; } = new(
        "--gridH", DecidesBytes.As(frame => frame.Settings.GridHorizontal), "PX", 1, int.MaxValue, "The same, horizontally")
    {
        Aliases = ["-gH"],
        DefaultNote = "--grid",
    };

    public static WholeNumberSpec GridVertical { get; } = new(
        "--gridV", DecidesBytes.As(frame => frame.Settings.GridVertical), "PX", 1, int.MaxValue, "The same, vertically")
    {
        Aliases = ["-gV"],
        DefaultNote = "--grid",
    };

    public static ChoiceSpec<PixelSurface> Surface { get; } = new(
        "--surface", DecidesBytes.As(frame => frame.Settings.Surface),
        [new Choice("sphere", PixelSurface.Sphere), new Choice("terrain", PixelSurface.Terrain)],
        "Where the meta file's pixels lie: on the reference sphere, or on the terrain that the image shows")
    {
        Default = PixelSurface.Sphere,
    };

    public static FlagSpec Annotation { get; } = new(
        "--rendering-annotation", DecidesBytes.As(frame => frame.Settings.Annotate).OfRuns(),
        "Make a second image with the illumination directions and the scene's data drawn on it");

    public static OptionGroup Group { get; } = new(
        "Output", [Folder, Name, Annotation, CameraModelOptions.OfRun, MapOptions.Map, Surface, Grid, GridHorizontal, GridVertical]);
}
