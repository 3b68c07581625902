namespace Msisf.Core.Metadata;

/// <summary>The elevation model of a frame, and the levels of detail that the frame was drawn at.</summary>
/// <param name="ProductId">Name of the model, e.g. "LDEM_64".</param>
/// <param name="IsSynthetic">Whether the model is synthetic, not the real Moon.</param>
/// <param name="PixelsPerDegree">Resolution of the model, px/deg.</param>
/// <param name="FinestDrawn">px/deg of the finest level in the image; the model's own where that was drawn.</param>
/// <param name="CoarsestDrawn">px/deg of the coarsest level in the image; the native renderer draws an image at one level.</param>
public sealed record DrawnElevation(string ProductId, bool IsSynthetic, int PixelsPerDegree, int FinestDrawn, int CoarsestDrawn);
