using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Lod;

namespace Msisf.App.Settings;

/// <summary>The options of the elevation model and its levels of detail.</summary>
internal static class SurfaceOptions
{
    /// <summary>Maximum resolution, px/deg: that of NASA's finest product (LDEM_1024).</summary>
    public const int MaxResolution = 1024;

    /// <summary>Maximum error of levels of detail, px: with a larger one the Moon would not be recognisable.</summary>
    private const double MaxLevelOfDetailError = 100.0;

    public static WholeNumberSpec Resolution { get; } = new(
        "--res", DecidesBytes.As(frame => frame.NamesOfSeveralModels is null ? frame.Settings.Resolution.PixelsPerDegree : null).AndTiles(),
        "PX/DEG", 1, MaxResolution, "Resolution of the elevation model")
    {
        Aliases = ["-r"],
        Default = 4,
        DefaultNote = "that of the file that --ldem names, otherwise 4",
    };

    public static PathSpec Ldem { get; } = new(
        "--ldem", DecidesBytes.As(frame => frame.NamesOfSeveralModels).AndTiles(),
        PathKind.Any,
        "Elevation model: its label, its image (of a split model any of them), any raster of a part of the Moon that GDAL reads, or a "
            + "folder of models; behind the path of a raster ,scale=METRES, ,offset=METRES and ,values=means|samples say what its "
            + "values are; "
            + ",offset=METRES|auto and ,shift=EAST,NORTH (m) move a map; "
            + "given several times, the finest model wins where it has data")
    {
        TakesSeveral = true,
        DefaultNote = "./input/ldem, then that of the installation",
    };

    public static ChoiceSpec<int> Body { get; } = new(
        "--body", DecidesBytes.As(frame => frame.Settings.Body.IsMoon ? null : frame.Settings.Body.NaifNumber).OfRuns(),
        [.. CelestialBody.All.Select(body => new Choice(body.Name.ToLowerInvariant(), body.NaifNumber))],
        "Body that is drawn; another one than the Moon needs --ldem with a model of it, and --renderer native")
    {
        Default = CelestialBody.Moon.NaifNumber,
    };

    public static ChoiceSpec<bool> LevelOfDetail { get; } = new(
        "--lod", DecidesBytes.As(frame => frame.Settings.LevelOfDetailError is null ? true : null).AndTiles(),
        [new Choice("auto", false), new Choice("off", true)],
        "Coarser levels of the model where its cells are smaller than a pixel, or always the model itself")
    {
        Default = false,
    };

    public static NumberSpec LevelOfDetailError { get; } = new(
        "--lod-error", DecidesBytes.As(frame => frame.Settings.LevelOfDetailError).AndTiles(),
        "PX", "How far coarser levels may move what is seen")
    {
        Limits = new NumberRange(0.0, MaxLevelOfDetailError),
        DefaultNote = Invariant($"{DetailRule.DefaultError}"),
    };

    public static OptionGroup Group { get; } = new("Surface model", [Resolution, Ldem, Body, LevelOfDetail, LevelOfDetailError]);
}
