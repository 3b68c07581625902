using System.CommandLine;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Series;
using Msisf.Cli.Options;

namespace Msisf.Cli.Commands;

/// <summary>
/// <c>msis status</c> and <c>msis verify</c>: whether a folder holds all frames of its runs, quickly or by reading every file.
/// </summary>
internal static class CheckCommand
{
    /// <summary>Frames are missing, damaged, failed or of other settings.</summary>
    public const int ExitNotComplete = 5;

    /// <summary>Declares the quick one.</summary>
    public static Command CreateStatus(ProgramHost host) => Create(
        "status",
        "Says which frames of the runs in a folder are there, missing, damaged or of other settings, by their lengths; "
            + "exit code 0 if all are well.",
        (folder, cancellation) => FrameSet.Read(folder, CheckDepth.Lengths, structure: null, host.Log, cancellation),
        host);

    /// <summary>Declares the thorough one.</summary>
    public static Command CreateVerify(ProgramHost host) => Create(
        "verify",
        "The same by reading every file: checksums, images whole, meta files valid.",
        (folder, cancellation) => FrameSet.Read(
            folder, CheckDepth.Checksums, new FileStructure(host.Installation.MetaFileDtd), host.Log, cancellation),
        host);

    private static Command Create(string name, string description, Func<string, CancellationToken, FrameSet> read, ProgramHost host)
    {
        Argument<string> folder = FolderArgument();
        Option<bool> printFrames = OptionFactory.Flag(
            "--print-frames", [], "Print only the steps that have to be made again, as --frames takes them; an empty line if none");
        Command command = new(name, description) { folder, printFrames };
        command.SetAction((line, cancellation) => Task.Run(
            () =>
            {
                StrayOptions.Refuse(line);
                FrameSet frames = read(line.GetRequiredValue(folder), cancellation);
                if (line.GetValue(printFrames))
                {
                    host.Results.WriteLine(frames.StepsToMake().ToString());
                }
                else
                {
                    frames.Print(host.Results);
                }

                return frames.CountOf(FrameState.Complete) == frames.Count ? 0 : ExitNotComplete;
            },
            cancellation));
        return command;
    }

    /// <summary>The folder of outputs that a command looks at.</summary>
    public static Argument<string> FolderArgument() => new("folder") { HelpName = "DIR", Description = "The --output-dir of the runs" };
}
