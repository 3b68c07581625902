using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Navigation;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Rendering;

/// <summary>Finds and writes the derivatives of frames, what their images tell, and what is certain of them. Thread-safe.</summary>
/// <param name="settings">Settings of the native renderer, with what is wanted.</param>
internal sealed class SensitivityOutputs(NativeSettings settings)
{
    /// <param name="stem">Path of the frame's files, without extension.</param>
    public IReadOnlyList<string> Write(
        AtomicFileSet files, string stem, RenderedFrame rendered, FrameMetadata metadata, LayerProvenance provenance,
        CancellationToken cancellation)
    {
        NavigationSettings wanted = settings.Navigation!;
        List<string> paths = [];
        if (wanted.Sensitivity is not null || wanted.Information is not null)
        {
            ImageSensitivity found = rendered.FindSensitivity!(cancellation);
            if (wanted.Sensitivity is { } parameters)
            {
                WriteLayers("sensitivity", SensitivityLayers.Of(found.Field, parameters, found.Signal));
            }

            if (wanted.Information is { } unknowns)
            {
                FisherInformation information = found.InformationOf!(unknowns);
                files.WriteText($"{stem}.information.csv", writer => InformationCsvWriter.Write(writer, information));
                paths.Add($"{stem}.information.csv");
            }
        }

        if (wanted.Limits is { } limits)
        {
            WriteLayers("certain", CertainLayers.Of(rendered.FindCertain!(limits, cancellation)));
        }

        return paths;

        void WriteLayers(string name, LayerSet layers)
        {
            if (settings.LayersFormat == LayersFormat.Npy)
            {
                paths.AddRange(NpyLayerWriter.Write(
                    files, $"{stem}.{name}", metadata, provenance, rendered.Truth!, layers, settings.LayersPrecision, cancellation));
                return;
            }

            files.Write($"{stem}.{name}.fits", stream => FitsLayerWriter.Write(
                stream, metadata, provenance, rendered.Truth!, layers, settings.LayersPrecision, settings.LayersCompression, cancellation));
            paths.Add($"{stem}.{name}.fits");
        }
    }
}
