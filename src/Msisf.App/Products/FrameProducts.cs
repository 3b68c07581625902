using Msisf.Adapters.CameraExport;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Navigation;
using Msisf.Adapters.Render;
using Msisf.Core.Detector;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;

namespace Msisf.App.Products;

/// <summary>Writes the products that need no more than a writer.</summary>
internal static class FrameProducts
{
    public static void Image(ProductFrame frame, PutFile put) => put("png", null, stream =>
    {
        frame.Rendered.Image.Position = 0;
        PngFile.CopyImage(frame.Rendered.Image, stream, frame.Rendered.ImageName);
    });

    public static void Annotated(ProductFrame frame, PutFile put) => put("annotated.png", null, stream =>
    {
        frame.Rendered.Image.Position = 0;
        AnnotationRenderer.Write(frame.Rendered.Image, stream, frame.Metadata, frame.Pixels, frame.Cancellation);
    });

    public static void Meta(ProductFrame frame, PutFile put) => put(
        "xml", null, stream => MetadataXmlWriter.Write(stream, frame.Metadata, frame.Pixels, cancellation: frame.Cancellation));

    public static void Numbers(ProductFrame frame, PutFile put)
    {
        DetectorSettings exposed = frame.Settings.Native.Detector!.Settings.Exposed(frame.Frame.ExposureFactor);
        put("dn.fits", null, stream => DetectorFitsWriter.Write(
            stream, frame.Rendered.Numbers!, exposed, frame.Metadata, frame.Provenance));
    }

    /// <summary>The camera with the digits of the meta file; a detector's shutter, which is not in there, too.</summary>
    public static void CameraModels(ProductFrame frame, PutFile put)
    {
        IReadOnlyList<CameraFormat> formats = frame.Settings.CameraFormats;
        ExportedFrame exported = MetaFileFrame.Of(frame.Frame.Name, frame.Metadata);
        CameraFormat.Write(
            formats,
            put,
            exported with
            {
                Scan = frame.Settings.Shutter is { IsRolling: true } shutter
                    && frame.Frame is { Scan: null, Motion: { IsRest: false } motion }
                    ? ExportedScan.OfShutter(exported.Camera, motion, shutter.LineTime, frame.Metadata.HeightOverTerrain)
                    : exported.Scan,
                Ephemeris = frame.Tools.Ephemeris,
                Image = formats.Any(format => format.HasPixels) ? frame.Image : null,
            },
            frame.Tools.Log.Note,
            frame.Tools.Log.Warning);
    }

    public static void Craters(ProductFrame frame, PutFile put)
    {
        FrameMetadata metadata = frame.Metadata;
        double referenceRadius = metadata.Globe.ReferenceRadius;
        put.Text(
            "craters.csv", writer => NavigationCsvWriter.Write(writer, metadata.Navigation!.Craters!, referenceRadius));
        put("craters.json", null, stream => CocoWriter.Write(
            stream, metadata.Navigation!.Craters!, metadata.Camera,
            new CocoSource($"Craters of {frame.Frame.Name}", metadata.Version, [CocoSource.NoLicence]),
            new CocoImage(frame.Frame.Step, $"{frame.Frame.Name}.png", metadata.SimulationTime), referenceRadius));
    }

    public static void Landmarks(ProductFrame frame, PutFile put) => put.Text(
        "landmarks.csv",
        writer => NavigationCsvWriter.Write(writer, frame.Metadata.Navigation!.Landmarks!, frame.Metadata.Globe.ReferenceRadius));

    public static void Layers(ProductFrame frame, PutFile put)
    {
        LayerSet layers = frame.Settings.Native.Layers!;
        frame.Settings.Native.LayersFormat.Write(frame.Of(layers) with { Truth = frame.TruthFor(layers) }, put);
    }
}
