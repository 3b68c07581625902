using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Preparation;

/// <summary>Writes a synthetic elevation model.</summary>
internal static class SyntheticModel
{
    /// <summary>Writes the model.</summary>
    /// <param name="settings">Describes the model.</param>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>Path of the model's label.</returns>
    /// <exception cref="MsisfException">The base model is not suitable, or the folder can't be written.</exception>
    public static string Write(SynthesisSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using LdemImage? continued = settings.BaseModel is { } path ? LdemImage.Open(LdemCatalog.Read(path)) : null;
        if (settings.Map is { } map)
        {
            return WriteMap(map, settings, continued, host, cancellation);
        }

        SyntheticLdemOptions options = new(settings.PixelsPerDegree, settings.Seed, settings.Folder)
        {
            Body = settings.Body,
            Base = continued,
            Region = settings.Region,
            Rest = settings.Rest,
            Format = settings.SampleType is { } type
                ? new SyntheticSampleFormat(type)
                : SyntheticLdemOptions.DefaultFormat(settings.PixelsPerDegree),
        };
        using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        return SyntheticLdemWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation);
    }

    private static string WriteMap(
        SyntheticMapSettings map, SynthesisSettings settings, LdemImage? continued, ProgramHost host, CancellationToken cancellation)
    {
        SyntheticMapOptions options = new(map.IsSouth, map.MetresPerPixel, map.LatitudeDegrees, settings.Seed, settings.Folder)
        {
            Base = continued,
            Format = new SyntheticSampleFormat(settings.SampleType ?? LdemSampleType.Float32LittleEndian),
        };
        using IRunProgress progress = host.Progress.Start("Synthesis", FractionProgress.Steps, settings.Unattended);
        return ModelOptions.Latitude.NamedInErrors(
            () => SyntheticMapWriter.Write(options, new FractionProgress(progress, "synthesis"), cancellation));
    }
}
