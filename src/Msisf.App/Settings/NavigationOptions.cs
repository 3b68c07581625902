using Msisf.App.Settings.Specs;
using Msisf.Core.Navigation;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Settings;

/// <summary>The options of truth for navigation.</summary>
internal static class NavigationOptions
{
    /// <summary>px: smaller craters are hardly found in images.</summary>
    public const double DefaultCraterSize = 5.0;

    /// <summary>px: larger than any image.</summary>
    private const double MaxCraterSize = 1e5;

    /// <summary>m: a rig as large as the Moon's orbit.</summary>
    private const double MaxBaseline = 1e9;

    /// <summary>1: far more than any estimate is sure of.</summary>
    private const double MaxSigmas = 100.0;

    private const string DefaultFlowFormat = "fits";

    public static PathSpec Craters { get; } = new(
        "--craters", DecidesBytes.As(frame => Path.GetFileName(frame.Native?.Navigation?.Craters)), PathKind.File,
        "Lists the craters of a catalogue (CSV) in each image, as ellipses of their rims, in the meta file, as CSV and as COCO JSON");

    public static ChoiceSpec<CraterRim> Rim { get; } = new(
        "--crater-rim", DecidesBytes.UnlessDefault(frame => frame.WithCraters?.Rim),
        [new Choice("disc", CraterRim.Disc), new Choice("terrain", CraterRim.Terrain)],
        "The rim of a crater: the catalogue's circle or ellipse in the plane of its centre, or the highest ground about there")
    {
        Default = CraterRim.Disc,
    };

    public static NumberSpec CraterSize { get; } = new(
        "--crater-size", DecidesBytes.UnlessDefault(frame => frame.WithCraters?.LeastDiameter), "PX",
        "Least diameter in the image of craters that are listed; smaller ones are counted")
    {
        Default = DefaultCraterSize,
        Limits = new NumberRange(0.0, MaxCraterSize),
    };

    public static PathSpec Landmarks { get; } = new(
        "--landmarks", DecidesBytes.As(frame => Path.GetFileName(frame.Native?.Navigation?.Landmarks)), PathKind.File,
        "Lists where each image shows the points of a list (CSV), with partial derivatives, in the meta file and as CSV");

    public static TextSpec Columns { get; } = new(
        "--columns", DecidesBytes.UnlessDefault(frame => frame.Native?.Navigation?.Columns?.ToString()), "KEY=COLUMN,...",
        "Which columns of the lists mean what, by name or number, where they are not found by their names: id, name, lat, lon, diam_km, "
            + "diam_m, major_km, minor_km, angle_deg, height, x, y, z");

    /// <summary>The word for the next frame of the run.</summary>
    public const string NextFrame = "next";

    /// <summary>The word for the frame of the run before.</summary>
    public const string PreviousFrame = "previous";

    /// <summary>The word for the other frame of a pair: steps 1 and 2, 3 and 4, and so on.</summary>
    public const string PairedFrame = "pair";

    public static TextSpec Flow { get; } = new(
        "--flow", DecidesBytes.ByStatesOfRun, $"{NextFrame}|{PreviousFrame}|{PairedFrame}|FILE|STATE",
        "Where each pixel's surface point lies in another image, whether that shows it, and how the light differs: of the run's next or "
            + "previous image, of the other of its pair (1 and 2, 3 and 4, ...), of a meta file, or of a state {MJD,rx,ry,rz,qx,qy,qz,q0}")
    {
        Words = [NextFrame, PreviousFrame, PairedFrame],
    };

    public static NumberSpec Stereo { get; } = new(
        "--stereo", DecidesBytes.As(frame => frame.Native?.Navigation?.Stereo).OfRuns(), "METRES",
        "Disparity of each pixel to a camera so far to the right of this one that looks the same way")
    {
        Limits = new NumberRange(0.0, MaxBaseline) { ExcludesMin = true },
    };

    public static TextSpec FlowFormat { get; } = new(
        "--flow-format", DecidesBytes.UnlessDefault(frame => frame.Native?.Navigation?.FlowFormatNames).OfRuns(), "LIST",
        "Formats of flow and disparity, separated by commas: fits and npy (double precision), flo (Middlebury), kitti (PNG)")
    {
        Default = DefaultFlowFormat,
        Separator = ",",
        Words = ["fits", "npy", "flo", "kitti"],
    };

    /// <summary>The word for the camera's position and orientation.</summary>
    public const string Pose = "pose";

    public static TextSpec Sensitivity { get; } = new(
        "--sensitivity",
        DecidesBytes.As(frame => frame.Native?.Navigation?.Sensitivity?.Select(parameter => parameter.Name)), "LIST|all",
        "Derivatives of every pixel by the camera's position and orientation, its focal length and principal point, the Sun's direction "
            + "and the albedo, as names separated by commas: position-x,turn-y, ...")
    {
        Separator = ",",
        Words = [Parameter.AllText, .. Parameter.All.Select(parameter => parameter.Name)],
    };

    public static TextSpec Information { get; } = new(
        "--information",
        DecidesBytes.As(frame => frame.Native?.Navigation?.Information?.Select(parameter => parameter.Name)), $"{Pose}|LIST|all",
        "How accurately the image of a camera with a detector can tell its pose, or the numbers of a list as in --sensitivity: Fisher "
            + "information and Cramer-Rao bound as CSV")
    {
        Separator = ",",
        Words = [Pose, Parameter.AllText, .. Parameter.All.Select(parameter => parameter.Name)],
    };

    public static TextSpec Certify { get; } = new(
        "--certify", DecidesBytes.As(frame => frame.Native?.Navigation?.Certify), "KEY=SIGMA,...",
        "The least and greatest brightness of each pixel, and which pixels are lit or dark for certain. Standard deviations are given: of "
            + "heights (height), the model's step (step) and the camera (position) in m, of the camera (turn) and the Sun (sun) in "
            + "degrees, e.g. height=1,position=10,turn=0.01")
    {
        Separator = ",",
    };

    public static NumberSpec Sigmas { get; } = new(
        "--certify-sigmas", DecidesBytes.UnlessDefault(frame => frame.Native?.Navigation?.Sigmas), "K",
        "How many standard deviations --certify allows; a model's step counts half, once")
    {
        Default = 3.0,
        Limits = new NumberRange(0.0, MaxSigmas),
    };

    /// <summary>The options that name a list of places; in a request it is a name of the server's.</summary>
    public static IReadOnlyList<PathSpec> Lists => [Craters, Landmarks];

    public static IReadOnlyList<OptionSpec> OfCraters => [Rim, CraterSize];

    public static OptionGroup Group { get; } = new(
        "Truth for navigation",
        [Craters, Rim, CraterSize, Landmarks, Columns, Flow, Stereo, FlowFormat, Sensitivity, Information, Certify, Sigmas])
    {
        Note = "Only with --renderer native.",
    };
}
