using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

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
                ? throw new UsageException("--format is for --dry-run only. Add that, or leave it out.").About(Format)
                : null;
        }

        return PovOptions.ListPatterns.Read(values)
            ? throw new UsageException("--dry-run and --list-patterns exclude each other. Leave one of them out.").About(DryRun)
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
