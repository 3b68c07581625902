using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Core.Layers;

/// <summary>Computes the layers of a frame, row by row; no row is kept. Safe for several threads.</summary>
public sealed class LayerSampler
{
    private readonly IGroundTruth _truth;
    private readonly int? _meshPixelsPerDegree;
    private readonly double _referenceRadius;
    private readonly double? _radianceOfUnitFactor;

    /// <summary>Prepares a frame.</summary>
    /// <param name="truth">What the pixels show.</param>
    /// <param name="provenance">Resolution of the cells, and the band of the radiance.</param>
    public LayerSampler(IGroundTruth truth, LayerProvenance provenance)
    {
        _truth = truth;
        _meshPixelsPerDegree = provenance.MeshResolution.PixelsPerDegree;
        _referenceRadius = provenance.ReferenceRadius;
        _radianceOfUnitFactor = truth.LightIsSun
            ? provenance.Band.RadianceOfUnitFactor(truth.LightPositionMoonMe.Length)
            : null;
    }

    /// <summary>px.</summary>
    public int Width => _truth.Camera.Width;

    /// <summary>px.</summary>
    public int Height => _truth.Camera.Height;

    /// <summary>Computes one row of some layers; each pixel is looked up once for all of them.</summary>
    /// <param name="row">0 (top) to <see cref="Height"/> - 1.</param>
    /// <param name="layers">The layers to compute.</param>
    /// <param name="planes">
    /// Filled: the planes of the first layer, then those of the second, ...; values from left to right, in the layer's unit; NaN
    /// marks the undefined ones. Whole numbers are exact.
    /// </param>
    /// <param name="start">Where the row begins in each plane.</param>
    public void SampleRow(int row, IReadOnlyList<Layer> layers, IReadOnlyList<double[]> planes, int start)
    {
        PinholeCamera camera = _truth.Camera;
        PixelTruth pixel = new(_truth, _meshPixelsPerDegree, _referenceRadius);
        (LayerValue Value, int Plane, double[] Values)[] targets = [.. Targets(layers, planes)];
        ReadOnlySpan<double> factors = _truth.RadianceFactors;
        ReadOnlySpan<double> electrons = _truth.Electrons;
        ReadOnlySpan<byte> saturated = _truth.Saturated;
        for (int column = 0; column < camera.Width; column++)
        {
            int index = (row * camera.Width) + column;
            ImageBrightness brightness = new(
                factors.IsEmpty ? null : factors[index],
                _radianceOfUnitFactor,
                electrons.IsEmpty ? null : electrons[index],
                saturated.IsEmpty ? null : saturated[index]);
            if (_truth.TryGet(column + 1, row + 1, out SurfaceHit hit, out PixelIllumination light))
            {
                pixel.MoveTo(camera.RayThrough(column + 1, row + 1), hit, light, brightness);
                foreach ((LayerValue value, int plane, double[] values) in targets)
                {
                    values[start + column] = value(pixel, plane) ?? double.NaN;
                }
            }
            else
            {
                FillEmpty(brightness, layers, planes, start + column);
            }
        }
    }

    /// <summary>Each plane with the function that computes its values.</summary>
    private static IEnumerable<(LayerValue Value, int Plane, double[] Values)> Targets(
        IReadOnlyList<Layer> layers, IReadOnlyList<double[]> planes)
    {
        int next = 0;
        foreach (Layer layer in layers)
        {
            for (int plane = 0; plane < layer.Planes; plane++)
            {
                yield return (layer.Value, plane, planes[next++]);
            }
        }
    }

    private static void FillEmpty(ImageBrightness brightness, IReadOnlyList<Layer> layers, IReadOnlyList<double[]> planes, int index)
    {
        int next = 0;
        foreach (Layer layer in layers)
        {
            double value = layer.EmptyValue(brightness)
                ?? (layer.Type == LayerType.Unsigned8 ? (double)IlluminationState.NoSurface : double.NaN);
            for (int plane = 0; plane < layer.Planes; plane++)
            {
                planes[next++][index] = value;
            }
        }
    }
}
