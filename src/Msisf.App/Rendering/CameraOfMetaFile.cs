using Msisf.Adapters.CameraExport;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Metadata;

namespace Msisf.App.Rendering;

/// <summary>The camera of a frame that was drawn just now, for other programs.</summary>
internal static class CameraOfMetaFile
{
    /// <summary>Reads it from the meta file, so that it is the same afterwards; a detector's shutter is not in there.</summary>
    /// <param name="metadata">What the meta file was written from.</param>
    /// <param name="settings">The options.</param>
    public static ExportedFrame Read(Stream stream, string name, Frame frame, FrameMetadata metadata, RenderSettings settings)
    {
        ExportedFrame exported = MetaFileFrame.Read(stream, name, () => RowStates.Of(metadata));
        return settings.Shutter is { IsRolling: true } shutter && frame is { Scan: null, Motion: { IsRest: false } motion }
            ? exported with
            {
                Scan = ExportedScan.OfShutter(exported.Camera, motion, shutter.LineTime, metadata.HeightOverTerrain),
            }
            : exported;
    }
}
