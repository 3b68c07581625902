using Msisf.App.Cluster;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis batchconvert</c>: converts a run to a script that makes it in pieces.</summary>
internal static class BatchConvertCommand
{
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        ScriptFormat format = ScriptOptions.ReadFormat(call.Values);
        string path = ScriptOptions.ReadPath(call.Values);
        ConvertedRun converted = new RunConversion(call.Host).Convert(call.Values, call.Words, format, _ => path, cancellation);
        call.Host.Log.Note(Invariant($"{converted.FrameCount} frames in {converted.PieceCount} pieces."));
        call.Host.Results.WriteLine(converted.Script);
        if (converted.StatesFile is not null)
        {
            call.Host.Results.WriteLine(converted.StatesFile);
        }

        return 0;
    }
}
