using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Navigation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Navigation;

namespace Msisf.App.Products;

/// <summary>Finds and writes the flow of a frame to another one, and the disparity to a camera beside it.</summary>
internal static class FlowProduct
{
    public static void WriteFlow(ProductFrame frame, PutFile put)
    {
        if (frame.Frame.Flow is { } target)
        {
            FlowField flow = Find(frame, target);
            WriteLayers(frame, put, "flow", FlowLayers.OfFlow(flow));
            Put(frame, FlowFormats.Middlebury, put, "flow.flo", stream => FlowFiles.WriteMiddlebury(stream, flow));
            Put(frame, FlowFormats.Kitti, put, "flow.png", stream => FlowFiles.WriteKitti(stream, flow));
        }
    }

    public static void WriteStereo(ProductFrame frame, PutFile put)
    {
        FrameCamera camera = CameraOf(frame);
        Vector3D baseline = frame.Settings.Native.Navigation!.Stereo!.Value * camera.UnitRight;
        CameraState right = camera.State with { PositionBodyFixed = camera.PositionBodyFixed + baseline };
        FlowField flow = Find(frame, new FlowTarget(camera.Model.At(right), frame.Frame.Light));
        WriteLayers(frame, put, "stereo", FlowLayers.OfStereo(flow));
        Put(frame, FlowFormats.Kitti, put, "disparity.png", stream => FlowFiles.WriteKittiDisparity(stream, flow));
    }

    private static FrameCamera CameraOf(ProductFrame frame) => (FrameCamera)frame.Frame.Camera; // FlowStates refuses others

    private static FlowField Find(ProductFrame frame, FlowTarget target) =>
        new FlowFinder(frame.Truth, frame.Rendered.Redraw!).Find(target, frame.Rendered.Threads, frame.Cancellation);

    private static bool Has(ProductFrame frame, FlowFormats format) => frame.Settings.Native.Navigation!.FlowFormats.HasFlag(format);

    private static void Put(ProductFrame frame, FlowFormats format, PutFile put, string name, Action<Stream> write)
    {
        if (Has(frame, format))
        {
            put(name, null, write);
        }
    }

    private static void WriteLayers(ProductFrame frame, PutFile put, string name, LayerSet layers)
    {
        Put(frame, FlowFormats.Fits, put, $"{name}.fits", stream => FitsLayerWriter.Write(
            stream, frame.Metadata, frame.Provenance, frame.Truth, layers, cancellation: frame.Cancellation));
        if (Has(frame, FlowFormats.Npy))
        {
            ArrayLayerWriter.Write(
                (file, length, write) => put(file == "layers.json" ? $"{name}.json" : file, length, write),
                frame.Metadata, frame.Provenance, frame.Truth, layers, cancellation: frame.Cancellation);
        }
    }
}
