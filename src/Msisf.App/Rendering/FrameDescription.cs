using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>Says about the frames of a run what their meta files and layers tell beside the image. Thread-safe.</summary>
/// <param name="inputs">The files that the frames are made from; may wait for their checksums.</param>
internal sealed class FrameDescription(
    RenderSettings settings, ElevationModel model, string version, Func<IReadOnlyList<InputFile>> inputs)
{
    /// <summary>Which kernels give the body's frame, for cameras on the trajectory of a mission; null for others.</summary>
    public string? Orientation { get; init; }

    /// <summary>What the meta file says of the whole frame.</summary>
    /// <param name="arguments">The canonical arguments of the frame.</param>
    public FrameMetadata Describe(Frame frame, RenderedFrame rendered, string arguments) => new(
        frame.Time,
        frame.Camera,
        settings.FieldOfViewDegrees,
        frame.Light.PositionBodyFixed,
        new DrawnElevation(
            model.Grid.ProductId, model.IsSynthetic, model.Grid.Resolution, rendered.Drawn.Finest, rendered.Drawn.Coarsest)
        {
            Parts = model.PartsAt(rendered.PartResolutions),
        },
        model.HeightOverTerrain(frame.Camera.PositionBodyFixed),
        version,
        arguments,
        rendered.Renderer,
        inputs())
    {
        Globe = new DrawnGlobe(settings.Body, model.Grid.ReferenceRadius),
        Orientation = Orientation,
        Scan = frame.Scan,
        Rig = settings.Rig,
        Stars = rendered.Sky?.Stars,
        Bodies = rendered.Sky?.Bodies,
    };

    /// <summary>The frame as its products are written from it.</summary>
    /// <param name="metadata">What <see cref="Describe"/> says, with the truth for navigation.</param>
    public ProductFrame ToProducts(
        Frame frame, RenderedFrame rendered, FrameMetadata metadata, ProductTools tools, CancellationToken cancellation) =>
        new(settings, frame, rendered, metadata, Sampler(frame, rendered), Provenance(metadata, rendered))
        {
            Tools = tools,
            Cancellation = cancellation,
        };

    private PixelSampler Sampler(Frame frame, RenderedFrame rendered)
    {
        PixelGrid grid = new(frame.Camera.Width, frame.Camera.Height, settings.GridHorizontal, settings.GridVertical);
        if (settings.Surface == PixelSurface.Sphere)
        {
            return new PixelSampler(frame.Camera, grid, new ReferenceSphere(model.Grid.ReferenceRadius), frame.Light);
        }

        ArgumentNullException.ThrowIfNull(rendered.Truth);
        return model.Grid.PartCount > 1
            ? PixelSampler.OfSeveral(grid, rendered.Truth)
            : new PixelSampler(grid, rendered.Truth, rendered.Resolution.PixelsPerDegree, model.Grid.ReferenceRadius);
    }

    /// <summary>What the layers' headers say of their origin.</summary>
    private LayerProvenance Provenance(FrameMetadata metadata, RenderedFrame rendered) => new(
        model.Grid.ProductId,
        rendered.Resolution,
        LevelOf(rendered),
        metadata.RendererName,
        settings.Albedo.Band)
    {
        Parts = model.Grid.PartCount,
        Sources = rendered.Terrain is { } terrain && model.Grid.PartCount > 1 ? new FacetSources(terrain) : null,
        InventedDetail = rendered.PartResolutions.Count > model.Sets.Count ? model.Grid.InventedName : null,
        ReferenceRadius = model.Grid.ReferenceRadius,
    };

    /// <summary>The level of detail; of several models that of the finest one that is drawn.</summary>
    private int LevelOf(RenderedFrame rendered) =>
        model.Grid.InventedName is null && model.PartsAt(rendered.PartResolutions) is { Count: > 0 } parts
        ? parts.Last(part => part.Drawn is not null).Resolution.HalvingsTo(rendered.Resolution)
        : model.Grid.Resolution.HalvingsTo(rendered.Resolution);
}
