using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Navigation;
using Msisf.App.Settings;
using Msisf.Core.Layers;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Products;

/// <summary>Finds and writes the derivatives of frames, what their images tell, and what is certain of them.</summary>
internal static class SensitivityProduct
{
    public static void Write(ProductFrame frame, PutFile put)
    {
        NavigationSettings wanted = frame.Settings.Native.Navigation!;
        ImageSensitivity found = frame.Rendered.FindSensitivity!(frame.Cancellation);
        if (wanted.Sensitivity is { } parameters)
        {
            WriteLayers(frame, put, "sensitivity", SensitivityLayers.Of(found.Field, parameters, found.Signal));
        }

        if (wanted.Information is { } unknowns)
        {
            FisherInformation information = found.InformationOf!(unknowns);
            put.Text("information.csv", writer => InformationCsvWriter.Write(writer, information));
        }
    }

    public static void WriteCertain(ProductFrame frame, PutFile put) => WriteLayers(
        frame, put, "certain",
        CertainLayers.Of(frame.Rendered.FindCertain!(frame.Settings.Native.Navigation!.Limits!, frame.Cancellation)));

    private static void WriteLayers(ProductFrame frame, PutFile put, string kind, LayerSet layers) => frame.Settings.Native.LayersFormat
        .Write(frame.Of(layers), (name, length, write) => put($"{kind}.{name}", length, write));
}
