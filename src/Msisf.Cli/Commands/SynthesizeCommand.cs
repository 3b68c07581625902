using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Commands;

/// <summary><c>msis ldem synthesize</c>: writes a synthetic elevation model.</summary>
internal static class SynthesizeCommand
{
    /// <summary>Does it.</summary>
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        SynthesisSettings settings = ModelOptions.ReadSynthesis(call.Values);
        using LdemImage? continued = settings.BaseModel is { } path ? ModelOptions.Base.Concerned(() => LdemImage.Open(LdemCatalog.Read(path))) : null;
        SyntheticLdemOptions options = new(settings.PixelsPerDegree, settings.Seed, settings.Folder) { Base = continued, Region = settings.Region };
        using IRunProgress progress = call.Host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        call.Host.Results.WriteLine(SyntheticLdemWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation));
        return 0;
    }
}
