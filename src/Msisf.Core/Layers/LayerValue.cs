namespace Msisf.Core.Layers;

/// <summary>Computes one value of a pixel that shows the surface.</summary>
/// <param name="pixel">What is known of the pixel.</param>
/// <param name="plane">0 to <see cref="Layer.Planes"/> - 1.</param>
/// <returns>In the layer's unit, finite; null where it is undefined.</returns>
internal delegate double? LayerValue(PixelTruth pixel, int plane);
