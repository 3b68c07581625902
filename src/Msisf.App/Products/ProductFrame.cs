using Msisf.Adapters.CameraExport;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Sky;

namespace Msisf.App.Products;

/// <summary>A frame that is drawn, from which its products are written.</summary>
/// <param name="Metadata">What the meta file says of it.</param>
/// <param name="Pixels">The pixels that the meta file lists.</param>
/// <param name="Provenance">What the headers of layers say of it.</param>
internal sealed record ProductFrame(
    RenderSettings Settings, Frame Frame, RenderedFrame Rendered, FrameMetadata Metadata, PixelSampler Pixels, LayerProvenance Provenance)
{
    public required ProductTools Tools { get; init; }

    public CancellationToken Cancellation { get; init; }

    /// <exception cref="InvalidOperationException">The renderer was not asked for it.</exception>
    public IGroundTruth Truth =>
        Rendered.Truth ?? throw new InvalidOperationException("The frame was drawn without its ground truth.");

    /// <summary>I/F of its pixels, or the numbers of a detector.</summary>
    public ExportedImage Image => ExportedImage.Of(Truth, Rendered.Detected);

    /// <summary>Layers with the form that the settings ask for.</summary>
    public LayersOfFrame Of(LayerSet layers) => new(Metadata, Provenance, Truth, layers)
    {
        Precision = Settings.Native.LayersPrecision,
        Compression = Settings.Native.LayersCompression,
        Cancellation = Cancellation,
    };

    /// <summary>The frame's truth with what layers need of craters and of the sky.</summary>
    public IGroundTruth TruthFor(LayerSet layers)
    {
        int[] craters = Metadata.Navigation?.Craters is { } found && layers.Layers.Any(layer => layer.NeedsCraters)
            ? CraterPixels.NumbersOf(found, Truth, threads: 1)
            : [];
        int[] objects = Rendered.Sky is { } sky && layers.Layers.Any(layer => layer.NeedsSky)
            ? SkyPixels.ObjectsOf(Truth, sky.Axes, sky.Stars, sky.Bodies, threads: 1)
            : [];
        return craters.Length + objects.Length == 0 ? Truth : new MarkedFrame(Truth, craters, objects);
    }
}

/// <summary>What products of all frames are written with.</summary>
/// <param name="GdalPath">MSISF_GDAL, or null.</param>
/// <param name="Ephemeris">For camera models; null where none needs it.</param>
internal sealed record ProductTools(ILog Log, string? GdalPath, IEphemeris? Ephemeris);
