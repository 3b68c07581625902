using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options that say how a run goes; none of them changes an image.</summary>
internal static class RunOptions
{
    /// <summary>More frames at once than any computer runs.</summary>
    private const int MaxJobs = 1024;

    /// <summary>Frames at once.</summary>
    public static WholeNumberSpec Jobs { get; } = new("--jobs", "N", 1, MaxJobs, "Images at once")
    {
        Aliases = ["-j"],
        DefaultNote = "as many as cores and memory allow",
    };

    /// <summary>Part of the run.</summary>
    public static TextSpec Frames { get; } = new(
        "--frames", "LIST", "Only these steps of the run, e.g. 1001:2000 or 3:5,17; numbers and names stay those of the whole run")
    {
        IsOfOneCall = true,
        DefaultNote = "all",
    };

    /// <summary>Makes all again.</summary>
    public static FlagSpec Overwrite { get; } = new(
        "--overwrite", "Make all images again, also those that are there and complete")
    {
        IsOfOneCall = true,
    };

    /// <summary>Stops early.</summary>
    public static FlagSpec FailFast { get; } = new("--fail-fast", "Stop at the first image that fails instead of going on with the others");

    /// <summary>Report of times.</summary>
    public static PathSpec FrameTimes { get; } = new(
        "--frame-times", PathKind.File, "Write a line for each image made: step, name, seconds; separated by tabs")
    {
        IsOfOneCall = true,
    };

    /// <summary>Times of the parts of the run.</summary>
    public static FlagSpec Timing { get; } = new("--timing", "Print run times as one line of JSON on standard error");

    /// <summary>No progress bars.</summary>
    public static FlagSpec Batch { get; } = new("--batch", "Unattended: ask nothing, draw no progress bars") { Aliases = ["-b"] };

    /// <summary>Settings of every call; every command takes it.</summary>
    public static PathSpec Config { get; } = new(
        "--config", PathKind.File,
        "Settings for options that are not given, one \"key: value\" a line; they go before those of ~/.config/msisf/config.yaml")
    {
        IsOfOneCall = true,
    };

    /// <summary>Prints help.</summary>
    public static FlagSpec Help { get; } = new("--help", "Show this help") { Aliases = ["-?"], IsOfOneCall = true };

    /// <summary>Prints the version.</summary>
    public static FlagSpec Version { get; } = new("--version", "Show the version of msis") { IsOfOneCall = true };

    /// <summary>All of a run's own.</summary>
    public static OptionGroup Group { get; } = new("Run", [Jobs, Frames, Overwrite, FailFast, Batch, FrameTimes, Timing, Config]);
}
