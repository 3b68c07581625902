namespace Msisf.Core.Layers;

/// <summary>Computes the values of one row of a layer.</summary>
/// <param name="row">What is known of the row.</param>
/// <param name="plane">0 to <see cref="Layer.Planes"/> - 1.</param>
/// <param name="values">
/// Receives a value for each pixel that shows the surface, from left to right, of a layer that <see cref="Layer.CoversImage"/> for each
/// pixel: in the layer's unit, NaN where it is undefined. Seven more may be written after them.
/// </param>
internal delegate void LayerValues(LayerRow row, int plane, double[] values);
