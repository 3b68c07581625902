using System.CommandLine;
using Msisf.App.Settings;

namespace Msisf.Cli.Options;

/// <summary>Which elevation model, which patterns, which ephemeris.</summary>
internal sealed class SourceOptions
{
    public Option<string?> Resolution { get; } = OptionFactory.Value(
        "--res", ["-r"], "RESOLUTION", "Resolution of the elevation model in px/deg (default 4)");

    public Option<string?> Ldem { get; } = OptionFactory.Value(
        "--ldem", [], "PATH",
        "Elevation model: its label, its image (of a split model any of them), or a folder of models (default ./input/ldem)");

    public Option<string?> PatternRepository { get; } = OptionFactory.Value(
        "--pattern-repos", ["-p"], "PATH", "Folder of the surface patterns (default ./pattern-repository/)");

    public IEnumerable<Option> All => [Resolution, Ldem, PatternRepository];

    /// <summary>Resolution of the elevation model, px/deg.</summary>
    public int ReadResolution(ParseResult line) =>
        line.GetValue(Resolution) is string text ? OptionText.WholeNumber(Resolution, text, 1, SourceSettings.FinestResolution) : 4;
}
