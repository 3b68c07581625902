using Msisf.Core.Camera;

namespace Msisf.Core.Sky;

/// <summary>A body of the sky of which an image shows some, or would but for the ground in front of it.</summary>
/// <param name="X">Rendering coordinate of its centre, in the middle of the exposure; may lie outside the image.</param>
/// <param name="Y">Rendering coordinate.</param>
/// <param name="RadiusPixels">px: angular radius of the equator, in the middle of the image's scale there.</param>
/// <param name="Visible">Part of its light, of that which falls on the image, that no ground hides, 0 to 1.</param>
public sealed record BodyView(BodyPlace Place, double X, double Y, double RadiusPixels, double Visible)
{
    /// <summary>Electrons that it frees in the image; null without a detector.</summary>
    public double? Electrons { get; init; }
}

/// <summary>The bodies of the sky of an image.</summary>
public sealed record BodiesOfFrame(IReadOnlyList<BodyView> Views);
