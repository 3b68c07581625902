using Msisf.Adapters.Manifest;
using Msisf.App.Series;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis status</c> and <c>msis verify</c>: whether a folder holds all frames of its runs, quickly or by reading every file.</summary>
internal static class CheckCommand
{
    /// <summary>Frames are missing, damaged, failed or of other settings.</summary>
    public const int ExitNotComplete = 5;

    /// <summary>The quick one.</summary>
    public static int Status(CommandCall call, CancellationToken cancellation) =>
        Report(call, FrameSet.Read(call.Values.Argument!, CheckDepth.Lengths, structure: null, call.Host.Log, cancellation));

    /// <summary>The thorough one.</summary>
    public static int Verify(CommandCall call, CancellationToken cancellation) => Report(call, FrameSet.Read(
        call.Values.Argument!, CheckDepth.Checksums, new FileStructure(call.Host.Installation.MetaFileDtd), call.Host.Log, cancellation));

    private static int Report(CommandCall call, FrameSet frames)
    {
        if (FolderOptions.PrintFrames.Read(call.Values))
        {
            call.Host.Results.WriteLine(frames.StepsToMake().ToString());
        }
        else
        {
            frames.Print(call.Host.Results);
        }

        return frames.CountOf(FrameState.Complete) == frames.Count ? 0 : ExitNotComplete;
    }
}
