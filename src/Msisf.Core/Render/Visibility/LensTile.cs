using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>Some pixels of an image with a lens, small enough that a linear map puts each sample near its pixel.</summary>
/// <param name="Pixels">The pixels.</param>
/// <param name="Map">
/// The linear map; it is no approximation of the samples, which stay where they are, but the plane that is drawn in.
/// </param>
/// <param name="Margin">px: maximum distance of a sample from its pixel along columns or rows.</param>
/// <param name="Tangents">The samples lie in this part of the ideal image plane.</param>
internal sealed record LensTile(PixelRange Pixels, ImagePlaneMap Map, double Margin, TangentBox Tangents);
