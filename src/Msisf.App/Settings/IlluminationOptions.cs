using Msisf.App.Settings.Specs;
using Msisf.Core.Render.Options;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>The options of <c>msis illumination</c>.</summary>
internal static class IlluminationOptions
{
    /// <summary>Cells of a region at most: their lights are held in memory, 0.2 kB each.</summary>
    public const int MaxCells = 4_000_000;

    /// <summary>Points at most: each gets a horizon by rays, a timetable and two plots.</summary>
    public const int MaxPoints = 1_000;

    private static readonly DecidesBytes Role = DecidesBytes.OfNoFrame;

    public static TextSpec Centre { get; } = new(
        "--center", Role, "LAT,LON|NAME", "Middle of the region (degrees north, degrees east), or the name of a place");

    public static TextSpec Size { get; } = new(
        "--size", Role, "KM[,KM]", "Width of the region on the ground, through its middle, and its height if that is another one");

    public static TextSpec Corners { get; } = new(
        "--corners", Role, "LAT,LON,LAT,LON",
        "Two opposite corners of the region, in place of its middle and size; across longitude 0 as in 350 and 10, or -10 and 10");

    public static NumberSpec Cell { get; } = new("--cell", Role, "METRES", "Width of a cell on the ground, in the middle of the region")
    {
        Limits = new NumberRange(0.1, 100_000.0),
        DefaultNote = "the pixels of the model that is finest there",
    };

    public static PathSpec Points { get; } = new(
        "--points", Role, PathKind.File, "Points in place of a region, or beside it: a CSV with columns lat and lon, and perhaps id, name");

    public static TextSpec Columns { get; } = new(
        "--columns", Role, "KEY=COLUMN,...", "Which columns of the points mean what, by name or number: id, name, lat, lon");

    public static TextSpec TimeInterval { get; } = CameraOptions.TimeInterval with
    {
        Role = Role,
        Help = "Times that are looked at: from start to end (UTC) in steps of days, or as in 10min, 1h; the brackets may be left out",
        IsRequired = true,
    };

    public static TextSpec Heights { get; } = new("--above-ground", Role, "METRES,...", "Heights over the ground, such as panels on masts")
    {
        Default = "0",
    };

    public static ChoiceSpec<SunModel> Sun { get; } = NativeOptions.Sun with
    {
        Role = Role,
        Help = "The Sun as its disc, darker at the limb, or as a point",
        Default = SunModel.Disc,
    };

    public static TextSpec Plane { get; } = new(
        "--plane", Role, "TILT,AZIMUTH", "A fixed plane whose light is wanted too: degrees from horizontal, degrees from north over east")
    {
        DefaultNote = "none",
    };

    public static NumberSpec NightLimit { get; } = new("--night-limit", Role, "HOURS", "Times without Sun that are longer are counted")
    {
        Default = 100.0,
        Limits = new NumberRange(0.0, 1e6),
    };

    public static FlagSpec Exact { get; } = new(
        "--exact", Role, "Decide by rays whether the Sun is in view wherever the error of the horizon, 0.005 degrees, leaves it open");

    public static ChoiceSpec<MapFormat> Format { get; } = new(
        "--format", Role,
        [new Choice("npy", MapFormat.Npy), new Choice("fits", MapFormat.Fits), new Choice("geotiff", MapFormat.GeoTiff)],
        "Form of the maps: arrays of NumPy, one FITS file, or Cloud Optimized GeoTIFFs, which GDAL writes")
    {
        Default = MapFormat.Npy,
    };

    public static PathSpec Compare { get; } = new(
        "--compare", Role, PathKind.File,
        "Compare the maps with LOLA's: a label LPSR_*.LBL (permanent shadow) or AVGVISIB_*.LBL (mean light) with its image; several times "
            + "for several")
    {
        TakesSeveral = true,
        DefaultNote = "none",
    };

    public static TextSpec Piece { get; } = new(
        "--piece", OptionRole.HowItRuns, "K/N",
        "Only a K-th of N parts of the work, and no maps; a last call without it takes what is there and writes them")
    {
        IsOfOneCall = true,
    };

    public static WholeNumberSpec Jobs { get; } = RunOptions.Jobs with
    {
        Help = "Cells or points at once",
        DefaultNote = "as many as cores",
    };

    public static PathSpec Folder { get; } = OutputOptions.Folder with
    {
        Default = "output/illumination",
        DefaultNote = "./output/illumination",
    };

    public static CommandSpec Command { get; } = new(
        "illumination", "Map how much of the time places are lit, and tell when the Sun rises there.")
    {
        Details =
            "Finds the horizon of each cell or point on the models, and compares it with the Sun's and the Earth's paths. Horizons are "
                + "kept in the folder and used again, after a kill too. docs/illumination.md says what the maps and tables hold.",
        Examples =
        [
            (
                "A ridge at the south pole over a year, hour by hour:",
                "msis illumination --center -89.45,222.7 --size 5 --cell 100 --time-interval 2026-01-01T00:00:00Z:1h:2027-01-01T00:00:00Z"),
            (
                "Tables of landing sites, 2 m over the ground:",
                "msis illumination --points sites.csv --above-ground 2 --time-interval 61041:1h:61406"),
        ],
        MakeGroups = () => [.. Groups, new OptionGroup("General", [RunOptions.Batch, RunOptions.Config, RunOptions.Help])],
    };

    /// <summary>The options as groups of the help text.</summary>
    private static IReadOnlyList<OptionGroup> Groups =>
    [
        new OptionGroup("Where", [Centre, Size, Corners, Cell, Points, Columns, Heights]),
        new OptionGroup("When and what", [TimeInterval, Sun, Exact, Plane, NightLimit]),
        new OptionGroup("Models and kernels", [
            SurfaceOptions.Resolution, SurfaceOptions.Ldem, SurfaceOptions.Body, LightOptions.Ephemeris, LightOptions.Kernels]),
        new OptionGroup("Output", [Format, Compare, Folder, Jobs, Piece]),
    ];
}

/// <summary>Forms of maps of light.</summary>
internal enum MapFormat
{
    /// <summary>Arrays of NumPy.</summary>
    Npy,

    /// <summary>One FITS file.</summary>
    Fits,

    /// <summary>Cloud Optimized GeoTIFFs.</summary>
    GeoTiff,
}
