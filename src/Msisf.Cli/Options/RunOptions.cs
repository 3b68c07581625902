using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>How the run goes: external parts, reports, limits.</summary>
internal sealed class RunOptions
{
    public Option<bool> Batch { get; } = OptionFactory.Flag("--batch", ["-b"], "Unattended: ask nothing, draw no progress bars");

    public Option<string?> Ephemeris { get; } = OptionFactory.Value(
        "--ephemeris", [], "cspice|builtin|auto", "Ephemeris engine (default auto: CSPICE if its library loads, else built-in)");

    public Option<string?> Aberration { get; } = OptionFactory.Value(
        "--aberration", [], "none|lt|lt+s",
        "Light's way from the Sun: none (default, geometric), light time, or with stellar aberration too");

    public Option<string?> Kernels { get; } = OptionFactory.Value(
        "--kernels", [], "FILE", "SPICE meta-kernel (default kernels/msisf.tm of the installation)");

    public Option<string?> PovPath { get; } = OptionFactory.Value(
        "--pov-path", [], "PATH", "POV-Ray's program or its folder (default: along the PATH)");

    public Option<string?> PovOptions { get; } = OptionFactory.Value(
        "--pov-options", [], "TEXT", "More POV-Ray options, separated by spaces; they overrule the usual ones, e.g. \"Antialias=Off\"");

    public Option<string?> Timeout { get; } = OptionFactory.Value(
        "--timeout", [], "SECONDS", "Longest time for one POV-Ray run (default: no limit)");

    public Option<string?> Jobs { get; } = OptionFactory.Value("--jobs", ["-j"], "N", "Frames at once (default: as many as cores allow)");

    public Option<string?> Frames { get; } = OptionFactory.Value(
        "--frames", [], "LIST", "Only these steps of the run, e.g. 1001:2000 or 3:5,17; numbers and names stay those of the whole run");

    public Option<bool> Overwrite { get; } = OptionFactory.Flag(
        "--overwrite", [], "Make all frames again, also those that are there and right");

    public Option<bool> FailFast { get; } = OptionFactory.Flag(
        "--fail-fast", [], "Stop at the first frame that fails (default: go on with the others)");

    public Option<string?> FrameTimes { get; } = OptionFactory.Value(
        "--frame-times", [], "FILE", "Write a line for each frame made: step, name, seconds; separated by tabs");

    public Option<bool> ListPatterns { get; } = OptionFactory.Flag(
        "--list-patterns", [], "Print the tiles of each frame and why each is taken or left out; render nothing");

    public Option<bool> Timing { get; } = OptionFactory.Flag("--timing", [], "Print run times as one line of JSON on standard error");

    public IEnumerable<Option> All =>
    [
        Batch, Ephemeris, Aberration, Kernels, PovPath, PovOptions, Timeout, Jobs, Frames, Overwrite, FailFast, FrameTimes, ListPatterns,
        Timing
    ];
}
