namespace Msisf.Cli.Help;

/// <summary>The exit codes and their meanings, for the manual page and docs/command-line-rules.md.</summary>
internal static class ExitCodes
{
    public static IReadOnlyList<(int Code, string Meaning)> All { get; } =
    [
        (0, "all is well"),
        (1, "wrong, missing or forbidden options; an option's value that is no such word or number, or out of range"),
        (
            2,
            "a file does not hold what it should, a configuration file too; or values that are right by themselves don't fit the model "
                + "or the machine"),
        (
            3,
            "CSPICE, POV-Ray or the file system failed or is missing; or some images of several failed (they are named, "
                + "the others are complete)"),
        (4, "valid input without an image in it: an empty batch file or interval (an image that misses the Moon is valid)"),
        (5, "status, verify, merge: images are missing, damaged, failed or of other settings"),
        (70, "a bug: please report the message with its stack"),
        (130, "ended by Ctrl-C, SIGTERM or a terminal that went away; finished images are complete, no other files are left"),
    ];
}
