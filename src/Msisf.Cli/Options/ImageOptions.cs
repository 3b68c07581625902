using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>What the image and its meta data look like and where they go.</summary>
internal sealed class ImageOptions
{
    public Option<string?> FieldOfView { get; } = OptionFactory.Value(
        "--fov", ["-f"], "DEGREES", "Horizontal field of view (default 40)");

    public Option<string?> Width { get; } = OptionFactory.Value("--width", ["-w"], "PX", "Image width, 1 to 16384 (default 1024)");

    public Option<string?> Height { get; } = OptionFactory.Value("--height", ["-h"], "PX", "Image height, 1 to 16384 (default 1024)");

    public Option<string?> Grid { get; } = OptionFactory.Value(
        "--grid", ["-g"], "PX", "Spacing of the pixels that the meta file lists, both ways (default 50)");

    public Option<string?> GridHorizontal { get; } = OptionFactory.Value("--gridH", ["-gH"], "PX", "The same, horizontally");

    public Option<string?> GridVertical { get; } = OptionFactory.Value("--gridV", ["-gV"], "PX", "The same, vertically");

    public Option<string?> Surface { get; } = OptionFactory.Value(
        "--surface", [], "sphere|terrain",
        "Where the meta file's pixels lie: on the reference sphere (default), or on the terrain that the image shows");

    public Option<string?> LevelOfDetail { get; } = OptionFactory.Value(
        "--lod", [], "auto|off",
        "Coarser levels of the model where its cells are below a pixel (default auto), or always the model itself");

    public Option<string?> LevelOfDetailError { get; } = OptionFactory.Value(
        "--lod-error", [], "PX",
        "How far, in pixels, they may move what is seen, 0 to 100 (default 0.33; native 0.35): a cell is at most twice as wide");

    public Option<bool> IgnoreSun { get; } = OptionFactory.Flag("--ignore-sun", [], "Light the scene from the camera instead of the Sun");

    public Option<bool> Annotation { get; } = OptionFactory.Flag(
        "--rendering-annotation", [], "Make a second image with the illumination directions and the scene's data drawn on it");

    public Option<string?> OutputFolder { get; } = OptionFactory.Value(
        "--output-dir", ["-o"], "PATH", "Folder of the outputs (default ./output/)");

    public Option<string?> OutputName { get; } = OptionFactory.Value(
        "--output-name", [], "PATTERN",
        "File names without extension; {step}, {step:00000}, {mjd}, {mjd:0.000} (default MoonSurfIllumSim_step_{step:00000})");

    public IEnumerable<Option> All =>
    [
        FieldOfView, Width, Height, Grid, GridHorizontal, GridVertical, Surface, LevelOfDetail, LevelOfDetailError, IgnoreSun, Annotation,
        OutputFolder, OutputName,
    ];
}
