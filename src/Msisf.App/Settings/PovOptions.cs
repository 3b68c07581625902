using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>What has a meaning with POV-Ray only.</summary>
internal static class PovOptions
{
    /// <summary>s: what a timer takes.</summary>
    private const int MaxTimeout = int.MaxValue / 1000;

    /// <summary>Folder of the surface patterns.</summary>
    public static PathSpec PatternRepository { get; } = new("--pattern-repos", PathKind.Folder, "Folder of the surface patterns")
    {
        Aliases = ["-p"],
        Default = "pattern-repository",
        DefaultNote = "./pattern-repository",
    };

    /// <summary>The program.</summary>
    public static PathSpec Program { get; } = new(
        "--pov-path", PathKind.Any, "POV-Ray's program or its folder")
    {
        DefaultNote = "searched along the PATH",
    };

    /// <summary>The user's own options of POV-Ray.</summary>
    public static TextSpec MoreOptions { get; } = new(
        "--pov-options", "TEXT", "More POV-Ray options, separated by spaces, which overrule those of msis, e.g. \"Antialias=Off\"")
    {
        Separator = " ",
    };

    /// <summary>Time limit, s.</summary>
    public static NumberSpec Timeout { get; } = new("--timeout", "SECONDS", "Longest time of one POV-Ray run")
    {
        Limits = new NumberRange(0.0, MaxTimeout) { ExcludesMin = true },
        DefaultNote = "no limit",
    };

    /// <summary>Prints, and renders nothing.</summary>
    public static FlagSpec ListPatterns { get; } = new(
        "--list-patterns", "Print the tiles of each image and why each is taken or left out; render nothing")
    {
        IsOfOneCall = true,
    };

    /// <summary>All of them.</summary>
    public static OptionGroup Group { get; } = new("POV-Ray", [PatternRepository, Program, MoreOptions, Timeout, ListPatterns])
    {
        Note = "Only with --renderer povray.",
    };
}
