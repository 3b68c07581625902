using Msisf.Adapters.Tiles;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>
/// The options of msis patterns. None takes a password, because all users of a computer can see the arguments of a program.
/// </summary>
internal static class PatternsOptions
{
    public static ChoiceSpec<bool> Source { get; } = new(
        "--source", DecidesBytes.OfNoFrame, [new Choice("ldem", false), new Choice("mysql", true)],
        "Where the samples come from: the elevation model's file, or the database of scripts/ldem_mysql_insert.php")
    {
        Default = false,
    };

    public static PathSpec DefaultsFile { get; } = new(
        "--defaults-file", DecidesBytes.OfNoFrame,
        PathKind.File,
        "With --source mysql: option file with the connection in its [client] group; "
            + "what it leaves out comes from MSISF_DB_HOST, _PORT, _SOCKET, _USER, _PASSWORD, _DATABASE and _SSL_CA");

    public static NumberSpec Margin { get; } = new(
        "--margin", DecidesBytes.OfNoFrame, "DEGREES", "Overlap with the neighbours, for scenes of 2012")
    {
        Limits = new NumberRange(0.0, PatternOptions.MaxMarginDegrees),
        Default = 0.0,
    };

    public static ChoiceSpec<PatternFormat> Format { get; } = new(
        "--format", DecidesBytes.OfNoFrame, [new Choice("mesh2", PatternFormat.Mesh2), new Choice("mesh", PatternFormat.Mesh)],
        "Form of the patterns: exact and compact, or the thesis's text form for old scenes")
    {
        Default = PatternFormat.Mesh2,
    };

    public static PathSpec ForBatch { get; } = CameraOptions.BatchFile with
    {
        Name = "--for-batch",
        Aliases = [CameraOptions.BatchFile.Name],
        Help = "Only the patterns that the images of this batch file need",
    };

    /// <summary>Options that apply only to the patterns of the whole Moon.</summary>
    public static OptionGroup WholeMoon { get; } = new("All patterns of the Moon", [Source, DefaultsFile, Margin, Format]);

    /// <summary>Options that apply both to the whole Moon and to a run.</summary>
    public static OptionGroup Model { get; } = new(
        "Surface model", [SurfaceOptions.Resolution, SurfaceOptions.Ldem, PovOptions.PatternRepository]);

    /// <summary>Options of a run that determine its patterns, except for the camera, the ephemeris and the selection of frames.</summary>
    public static IReadOnlyList<OptionSpec> Deciding { get; } =
        [.. CommandTable.OptionsOfRun.Where(option => option.Role is DecidesBytes { DecidesTiles: true }).Union(Model.Options)];

    /// <summary>Options that apply only to the patterns of a run.</summary>
    public static OptionGroup OfRun { get; } = new(
        "Patterns of a run",
        [ForBatch, .. CameraOptions.Group.Options.Where(option => option != CameraOptions.BatchFile), .. Deciding.Except(
            Model.Options), LightOptions.Ephemeris, RunOptions.Frames, RunOptions.Jobs])
    {
        Note = "The run is given by --for-batch, or as for msis itself. All of these must be what the run has.",
    };

    /// <summary>Reads the run whose patterns are made; null if none is given.</summary>
    /// <exception cref="MsisfException">An option is wrong, or can't be used with or without a run.</exception>
    public static (TrajectorySettings Trajectory, RenderSettings Settings)? ReadRun(OptionValues values)
    {
        if (TrajectorySettingsReader.ReadIfGiven(values, ForBatch) is not { } trajectory)
        {
            values.Refuse(OfRun.Options, $"is for the patterns of a run only. Say of which by {ForBatch.Name}, or leave it out.");
            return null;
        }

        values.Refuse(WholeMoon.Options, "has no meaning for the patterns of a run. Leave it out, or make those of the whole Moon.");
        return (trajectory, RenderSettingsReader.Read(values));
    }

    /// <summary>Reads the options for the patterns of the whole Moon.</summary>
    /// <exception cref="MsisfException">An option is wrong, or contradicts another.</exception>
    public static WholeMoonSettings ReadWholeMoon(OptionValues values)
    {
        PatternOptions patterns = Margin.Named(() => new PatternOptions(Margin.Read(values), Format.Read(values)));
        bool isDatabase = Source.Read(values);
        WholeMoonSettings settings = new(
            isDatabase ? SurfaceOptions.Resolution.Read(values) : ModelChoice.CylindricalResolutionOf(values),
            SurfaceOptions.Ldem.ReadIfGiven(values), isDatabase,
            DefaultsFile.ReadIfGiven(values),
            PovOptions.PatternRepository.Read(values), patterns, RunOptions.Batch.Read(values));
        return settings switch
        {
            { IsDatabase: true, Ldem: not null } =>
                throw SurfaceOptions.Ldem.Wrong("and --source mysql contradict each other. Give one of them.", Source),
            { IsDatabase: false, DefaultsFile: not null } =>
                throw DefaultsFile.Wrong("is for --source mysql only. Leave it out, or give --source mysql.", Source),
            _ => settings,
        };
    }
}

/// <summary>Selects the patterns of a whole model and the source of their samples.</summary>
/// <param name="PixelsPerDegree">Resolution of the model, px/deg.</param>
/// <param name="Ldem">The model's file or folder; null for the default folders or the database.</param>
/// <param name="IsDatabase">Whether to take the samples from the database.</param>
/// <param name="DefaultsFile">Option file with the connection to the database; null for the environment alone.</param>
/// <param name="PatternRepository">Folder of the patterns.</param>
/// <param name="Patterns">Format of the patterns.</param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record WholeMoonSettings(
    int PixelsPerDegree, string? Ldem, bool IsDatabase, string? DefaultsFile, string PatternRepository, PatternOptions Patterns,
    bool Unattended);
