using Msisf.App.Settings.Specs;
using Msisf.Core.Navigation;

namespace Msisf.App.Settings;

/// <summary>The options of truth for navigation.</summary>
internal static class NavigationOptions
{
    /// <summary>px: smaller craters are hardly found in images.</summary>
    public const double DefaultCraterSize = 5.0;

    /// <summary>px: larger than any image.</summary>
    private const double MaxCraterSize = 1e5;

    /// <summary>Catalogue of craters.</summary>
    public static PathSpec Craters { get; } = new(
        "--craters", DecidesBytes.As(frame => Path.GetFileName(frame.Native?.Navigation?.Craters)), PathKind.File,
        "Lists the craters of a catalogue (CSV) in each image, as ellipses of their rims, in the meta file, as CSV and as COCO JSON");

    /// <summary>Where rims lie.</summary>
    public static ChoiceSpec<CraterRim> Rim { get; } = new(
        "--crater-rim", DecidesBytes.UnlessDefault(frame => frame.WithCraters?.Rim).OfRuns(),
        [new Choice("disc", CraterRim.Disc), new Choice("terrain", CraterRim.Terrain)],
        "The rim of a crater: the catalogue's circle or ellipse in the plane of its centre, or the highest ground about there")
    {
        Default = CraterRim.Disc,
    };

    /// <summary>Least diameter in the image.</summary>
    public static NumberSpec CraterSize { get; } = new(
        "--crater-size", DecidesBytes.UnlessDefault(frame => frame.WithCraters?.LeastDiameter).OfRuns(), "PX",
        "Least diameter in the image of craters that are listed; smaller ones are counted")
    {
        Default = DefaultCraterSize,
        Limits = new NumberRange(0.0, MaxCraterSize),
    };

    /// <summary>List of landmarks.</summary>
    public static PathSpec Landmarks { get; } = new(
        "--landmarks", DecidesBytes.As(frame => Path.GetFileName(frame.Native?.Navigation?.Landmarks)), PathKind.File,
        "Lists where each image shows the points of a list (CSV), with partial derivatives, in the meta file and as CSV");

    /// <summary>The options that are of use with a catalogue only.</summary>
    public static IReadOnlyList<OptionSpec> OfCraters => [Rim, CraterSize];

    /// <summary>The options of this class as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new("Truth for navigation", [Craters, Rim, CraterSize, Landmarks])
    {
        Note = "Only with --renderer native.",
    };
}
