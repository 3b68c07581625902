using Msisf.Adapters.IO;
using Msisf.Adapters.Maps;
using Msisf.App.Settings;
using Msisf.Core.Maps;

namespace Msisf.App.Products;

/// <summary>Puts frames and their layers on a map.</summary>
internal static class MapProduct
{
    /// <summary>Writes the files; none if the frame shows no ground.</summary>
    public static void Write(ProductFrame frame, PutFile put)
    {
        MapSettings settings = frame.Settings.Map!;
        ImageMap? map = new ImageMapper(frame.Truth, frame.Rendered.Terrain!)
            .Find(settings.Kind, settings.Cell, frame.Rendered.Threads, frame.Cancellation);
        if (map is null)
        {
            frame.Tools.Log.Note($"{frame.Frame.Name} shows no ground, so there is no map of it.");
            return;
        }

        ImageMapFiles writer = new(map, frame.Metadata, frame.Tools.GdalPath);
        writer.WriteImage(put, frame.Image);
        if (frame.Settings.Native.Layers is { } layers)
        {
            writer.WriteLayers(
                put, frame.TruthFor(layers), frame.Provenance, layers, frame.Settings.Native.LayersPrecision, frame.Cancellation);
        }
    }
}
