using Msisf.Adapters.Layers;
using Msisf.Core.Certainty;
using Msisf.Core.Detector;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Sensitivity;
using Msisf.Core.Sky;
using Msisf.Core.Terrain;

namespace Msisf.App.Products;

/// <summary>The result of a renderer, from which the files of a frame are written.</summary>
/// <param name="Image">The image, PNG; can be read again from its start.</param>
/// <param name="ImageName">Name of the image in messages.</param>
/// <param name="WriteScene">Writes the scene that was rendered; null if the renderer has none.</param>
/// <param name="Resolution">Resolution of the grid whose cells the ground truth names: the model's, or its level's.</param>
/// <param name="Drawn">Resolution of the finest and of the coarsest level of detail in the image.</param>
/// <param name="Truth">Ground truth of the pixels; may be null if the meta file's pixels lie on the reference sphere.</param>
/// <param name="Detected">What the camera's detector read out; null without a detector.</param>
internal sealed record RenderedFrame(
    RendererKind Renderer,
    Stream Image,
    string ImageName,
    Action<TextWriter>? WriteScene,
    GridResolution Resolution,
    (GridResolution Finest, GridResolution Coarsest) Drawn,
    IGroundTruth? Truth,
    DetectorImage? Detected = null)
{
    /// <summary>Draws the frame again with other lights; null if the renderer can't.</summary>
    public FrameRedraw? Redraw { get; init; }

    /// <summary>Finds the derivatives of the frame; null if the renderer can't.</summary>
    public Func<CancellationToken, ImageSensitivity>? FindSensitivity { get; init; }

    /// <summary>Finds what is certain of the frame's pixels; null if the renderer can't.</summary>
    public Func<Uncertainty, CancellationToken, CertainImage>? FindCertain { get; init; }

    /// <summary>The detector's numbers as a file has them: of an image that is drawn in strips without <see cref="Detected"/>.</summary>
    public DetectorNumbers? Numbers { get => field ?? (Detected is null ? null : DetectorNumbers.Of(Detected)); init; }

    /// <summary>What the frame shows of the sky; null where none is drawn.</summary>
    public SkyOfFrame? Sky { get; init; }

    /// <summary>Number of threads that work on the frame.</summary>
    public int Threads { get; init; } = 1;

    /// <summary>The terrain that the image shows, at its level of detail; null if the renderer does not say.</summary>
    public ITerrain? Terrain { get; init; }

    /// <summary>Resolution at which each of several models is drawn; null for one that is left out. Empty for one model.</summary>
    public IReadOnlyList<GridResolution?> PartResolutions { get; init; } = [];
}

/// <summary>What a frame shows of the sky.</summary>
/// <param name="Stars">Null where none are drawn.</param>
/// <param name="Bodies">Null where none are drawn.</param>
/// <param name="Factors">What the sky adds to radiance factors of pixels, by rows from 0; empty with a detector.</param>
internal sealed record SkyOfFrame(StarsOfFrame? Stars, BodiesOfFrame? Bodies, IReadOnlyList<(int Pixel, double Factor)> Factors)
{
    /// <summary>How the sky lies, for each band of the frame's camera.</summary>
    public required IReadOnlyList<SkyAxes> Axes { get; init; }
}
