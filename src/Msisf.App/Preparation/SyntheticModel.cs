using Msisf.Adapters.Synthesis;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.App.Preparation;

/// <summary>Writes a synthetic elevation model.</summary>
internal static class SyntheticModel
{
    /// <summary>Writes it.</summary>
    /// <param name="settings">Which.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends it and leaves no file.</param>
    /// <returns>Its label.</returns>
    /// <exception cref="MsisfException">The model that it continues is unfit, or the folder can't be written.</exception>
    public static string Write(SynthesisSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using LdemImage? continued = settings.BaseModel is { } path ? LdemImage.Open(LdemCatalog.Read(path)) : null;
        SyntheticLdemOptions options = new(settings.PixelsPerDegree, settings.Seed, settings.Folder)
        {
            Base = continued,
            Region = settings.Region,
        };
        using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        return SyntheticLdemWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation);
    }
}
