using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>What a renderer hands over for a frame's files.</summary>
/// <param name="Renderer">Which.</param>
/// <param name="Image">The image, PNG; can be read again from its start.</param>
/// <param name="ImageName">What a message calls it.</param>
/// <param name="WriteScene">Writes the scene that was rendered; null if the renderer has none.</param>
/// <param name="PixelsPerDegree">px/deg of the surface that was drawn: the model's, or that of its level of detail.</param>
/// <param name="Truth">What the pixels show; may be null if the meta file's pixels lie on the reference sphere.</param>
internal sealed record RenderedFrame(
    RendererKind Renderer, Stream Image, string ImageName, Action<TextWriter>? WriteScene, int PixelsPerDegree, IGroundTruth? Truth);
