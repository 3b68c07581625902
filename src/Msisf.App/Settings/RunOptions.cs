using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options for the course of a run; none of them changes an image.</summary>
internal static class RunOptions
{
    /// <summary>Maximum number of frames at once: more than any computer can run.</summary>
    private const int MaxJobs = 1024;

    public static WholeNumberSpec Jobs { get; } = new("--jobs", OptionRole.HowItRuns, "N", 1, MaxJobs, "Images at once")
    {
        Aliases = ["-j"],
        DefaultNote = "as many as cores and memory allow",
    };

    public static TextSpec Frames { get; } = new(
        "--frames", OptionRole.HowItRuns,
        "LIST", "Only these steps of the run, e.g. 1001:2000 or 3:5,17; numbers and names stay those of the whole run")
    {
        IsOfOneCall = true,
        DefaultNote = "all",
    };

    public static FlagSpec Overwrite { get; } = new(
        "--overwrite", OptionRole.HowItRuns, "Make all images again, also those that are there and complete")
    {
        IsOfOneCall = true,
    };

    public static FlagSpec FailFast { get; } = new(
        "--fail-fast", OptionRole.HowItRuns, "Stop at the first image that fails instead of going on with the others");

    public static PathSpec FrameTimes { get; } = new(
        "--frame-times", OptionRole.WhatIsPrinted,
        PathKind.File, "Write a line for each image made: step, name, seconds; separated by tabs")
    {
        IsOfOneCall = true,
    };

    public static FlagSpec Timing { get; } = new(
        "--timing", OptionRole.WhatIsPrinted, "Print run times as one line of JSON on standard error");

    public static FlagSpec Batch { get; } = new(
        "--batch", OptionRole.WhatIsPrinted, "Unattended: ask nothing, draw no progress bars")
    { Aliases = ["-b"] };

    public static PathSpec Config { get; } = new(
        "--config", DecidesBytes.ByOthers, PathKind.File,
        "Settings for options that are not given, one \"key: value\" a line; they go before those of ~/.config/msisf/config.yaml")
    {
        IsOfOneCall = true,
    };

    public static FlagSpec Help { get; } = new(
        "--help", OptionRole.WhatIsPrinted, "Show this help")
    { Aliases = ["-?"], IsOfOneCall = true };

    public static FlagSpec Version { get; } = new("--version", OptionRole.WhatIsPrinted, "Show the version of msis") { IsOfOneCall = true };

    /// <summary>The options of a run as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new("Run", [Jobs, Frames, Overwrite, FailFast, Batch, FrameTimes, Timing, Config]);
}
