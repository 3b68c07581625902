using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis ldem pyramid</c>: makes or checks the sidecar with a model's levels of detail.</summary>
internal static class PyramidCommand
{
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        PyramidSettings settings = ModelOptions.ReadPyramid(call.Values);
        string? path = ModelOptions.Verify.Read(call.Values)
            ? ModelPyramid.Verify(settings, call.Host, cancellation)
            : ModelPyramid.Make(settings, call.Host, cancellation);
        if (path is not null)
        {
            call.Host.Results.WriteLine(path);
        }

        return 0;
    }
}

/// <summary><c>msis ldem synthesize</c>: writes a synthetic elevation model.</summary>
internal static class SynthesizeCommand
{
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        call.Host.Results.WriteLine(SyntheticModel.Write(ModelOptions.ReadSynthesis(call.Values), call.Host, cancellation));
        return 0;
    }
}
