using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of <c>msis states</c>.</summary>
internal static class StatesOptions
{
    private static readonly StatesFormat[] Tables = [StatesFormat.Batch, StatesFormat.Csv, StatesFormat.Tum];

    public static ChoiceSpec<StatesFormat> Format { get; } = new(
        "--format", OptionRole.HowItRuns,
        [
            ("batch", StatesFormat.Batch), ("csv", StatesFormat.Csv), ("oem", StatesFormat.Oem), ("spice", StatesFormat.Spice),
            ("tum", StatesFormat.Tum), ("euroc", StatesFormat.Euroc), ("colmap", StatesFormat.Colmap),
        ],
        "Batch file, CSV with named columns, CCSDS OEM and AEM, SPICE kernels (SPK, CK, SCLK, FK, IK), TUM, EuRoC, or COLMAP")
    {
        Default = StatesFormat.Batch,
    };

    public static PathSpec To { get; } = new(
        "--to", OptionRole.HowItRuns, PathKind.Any, "The file of batch, csv or tum; the folder of the others")
    {
        IsOfOneCall = true,
        DefaultNote = "batch, csv and tum are printed",
    };

    /// <summary>Reads where the states go; null to print them.</summary>
    /// <exception cref="UsageException">The form needs a folder, and none is given.</exception>
    public static string? ReadPath(OptionValues values)
    {
        StatesFormat format = Format.Read(values);
        return To.ReadIfGiven(values) ?? (Tables.Contains(format)
            ? null
            : throw new UsageException($"--format {Format.WordOf(format)} writes several files. Give the folder for them: --to DIR.")
                .About(To));
    }
}

/// <summary>The forms in which <c>msis states</c> writes.</summary>
internal enum StatesFormat
{
    /// <summary>The thesis's batch file.</summary>
    Batch,

    /// <summary>A batch file with named columns.</summary>
    Csv,

    /// <summary>CCSDS orbit and attitude ephemeris messages.</summary>
    Oem,

    /// <summary>SPICE kernels.</summary>
    Spice,

    /// <summary>A trajectory as TUM's benchmark has it.</summary>
    Tum,

    /// <summary>A folder as EuRoC's benchmark has it.</summary>
    Euroc,

    /// <summary>COLMAP's text model.</summary>
    Colmap,
}

/// <summary>How commands that list things print them.</summary>
internal static class TableOptions
{
    public static ChoiceSpec<bool> Format { get; } = new(
        "--format", OptionRole.WhatIsPrinted, [("table", false), ("json", true)],
        "A table for people, or an array of objects with all digits")
    {
        Default = false,
    };
}

/// <summary>The options of <c>msis places</c>.</summary>
internal static class PlacesOptions
{
    public static TextSpec Near { get; } = new(
        "--near", OptionRole.WhatIsPrinted, "LAT,LON|NAME",
        "Print the twenty nearest places and their distances along the sphere (degrees north, degrees east)");
}

/// <summary>The options that tell what the images of a run would show, and draw nothing.</summary>
internal static class DryRunOptions
{
    public static FlagSpec DryRun { get; } = new(
        "--dry-run", OptionRole.WhatIsPrinted,
        "Draw nothing; print what each image would show: where the camera is, where it looks, the Sun there, how much is lit")
    {
        IsOfOneCall = true,
    };

    public static ChoiceSpec<PreviewFormat> Format { get; } = new(
        "--format", OptionRole.WhatIsPrinted,
        [("table", PreviewFormat.Table), ("csv", PreviewFormat.Csv), ("json", PreviewFormat.Json)],
        "Form in which --dry-run prints")
    {
        Default = PreviewFormat.Table,
    };

    /// <summary>Reads the form; null if the run is to be drawn.</summary>
    /// <exception cref="MsisfException">The form is wrong or given without <c>--dry-run</c>, or another option prints too.</exception>
    public static PreviewFormat? Read(OptionValues values)
    {
        PreviewFormat format = Format.Read(values);
        if (!DryRun.Read(values))
        {
            return values.IsGiven(Format)
                ? throw Format.Wrong("is for --dry-run only. Add that, or leave it out.")
                : null;
        }

        return PovOptions.ListPatterns.Read(values)
            ? throw DryRun.Wrong("and --list-patterns exclude each other. Leave one of them out.")
            : format;
    }
}

/// <summary>The form in which <c>--dry-run</c> prints.</summary>
internal enum PreviewFormat
{
    /// <summary>Aligned columns with few digits, for people.</summary>
    Table,

    /// <summary>Comma-separated values with a header and all digits.</summary>
    Csv,

    /// <summary>An array of objects with all digits.</summary>
    Json,
}
