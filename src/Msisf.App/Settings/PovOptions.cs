using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options that apply to POV-Ray only.</summary>
internal static class PovOptions
{
    /// <summary>Maximum time limit, s: the longest that a .NET timer accepts.</summary>
    private const int MaxTimeout = int.MaxValue / 1000;

    public static PathSpec PatternRepository { get; } = new(
        "--pattern-repos", OptionRole.HowItRuns, PathKind.Folder, "Folder of the surface patterns")
    {
        Aliases = ["-p"],
        Default = "pattern-repository",
        DefaultNote = "./pattern-repository",
    };

    public static PathSpec Program { get; } = new(
        "--pov-path", DecidesBytes.ByFiles, PathKind.Any, "POV-Ray's program or its folder")
    {
        DefaultNote = "searched along the PATH",
    };

    public static TextSpec MoreOptions { get; } = new(
        "--pov-options", DecidesBytes.As(frame => frame.Native is null ? frame.Settings.PovOptions : null).OfRuns(),
        "TEXT", "More POV-Ray options, separated by spaces, which overrule those of msis, e.g. \"Antialias=Off\"")
    {
        Separator = " ",
    };

    public static NumberSpec Timeout { get; } = new("--timeout", OptionRole.HowItRuns, "SECONDS", "Longest time of one POV-Ray run")
    {
        Limits = new NumberRange(0.0, MaxTimeout) { ExcludesMin = true },
        DefaultNote = "no limit",
    };

    public static FlagSpec ListPatterns { get; } = new(
        "--list-patterns", OptionRole.WhatIsPrinted, "Print the tiles of each image and why each is taken or left out; render nothing")
    {
        IsOfOneCall = true,
    };

    public static OptionGroup Group { get; } = new("POV-Ray", [PatternRepository, Program, MoreOptions, Timeout, ListPatterns])
    {
        Note = "Only with --renderer povray.",
    };
}
