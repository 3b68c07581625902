using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis ldem synthesize</c>: writes a synthetic elevation model.</summary>
internal static class SynthesizeCommand
{
    /// <summary>Runs the command.</summary>
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        call.Host.Results.WriteLine(SyntheticModel.Write(ModelOptions.ReadSynthesis(call.Values), call.Host, cancellation));
        return 0;
    }
}
