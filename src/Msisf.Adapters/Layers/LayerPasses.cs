using System.Buffers;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Computes a frame's layers, all rows in parallel. A few layers are computed at a time, so that memory does not grow with their number.
/// </summary>
internal static class LayerPasses
{
    /// <summary>
    /// Bytes of the planes of one pass. At 1024 x 1024 px all layers take four passes, so each pixel is looked up four times instead of
    /// once a layer.
    /// </summary>
    private const long MemoryOfAPass = 64L << 20;

    /// <summary>Computes layers and passes them on, one after the other.</summary>
    /// <param name="sampler">The frame.</param>
    /// <param name="layers">Which, in their order.</param>
    /// <param name="use">
    /// Gets a layer and its planes, <c>[y * width + x]</c>, as <see cref="LayerSampler.SampleRow"/> fills them; they may be longer
    /// than that, and are filled anew afterwards.
    /// </param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Run(
        LayerSampler sampler, IReadOnlyList<Layer> layers, Action<Layer, IReadOnlyList<double[]>> use, CancellationToken cancellation)
    {
        int pixels = checked(sampler.Width * sampler.Height);
        int planesAtOnce = (int)Math.Max(1, MemoryOfAPass / sizeof(double) / pixels);
        List<double[]> planes = [];
        try
        {
            foreach (Layer[] pass in Passes(layers, planesAtOnce))
            {
                while (planes.Count < pass.Sum(layer => layer.Planes))
                {
                    planes.Add(ArrayPool<double>.Shared.Rent(pixels));
                }

                RunPass(sampler, pass, planes, use, cancellation);
            }
        }
        finally
        {
            planes.ForEach(plane => ArrayPool<double>.Shared.Return(plane));
        }
    }

    private static void RunPass(
        LayerSampler sampler, Layer[] pass, List<double[]> planes, Action<Layer, IReadOnlyList<double[]>> use,
        CancellationToken cancellation)
    {
        Parallel.For(
            0,
            sampler.Height,
            new ParallelOptions { CancellationToken = cancellation },
            row => sampler.SampleRow(row, pass, planes, row * sampler.Width));
        int first = 0;
        foreach (Layer layer in pass)
        {
            cancellation.ThrowIfCancellationRequested();
            use(layer, planes.GetRange(first, layer.Planes));
            first += layer.Planes;
        }
    }

    /// <summary>As many layers at once as fit; one at least, or two that share their computation.</summary>
    private static IEnumerable<Layer[]> Passes(IReadOnlyList<Layer> layers, int planesAtOnce)
    {
        List<Layer> pass = [];
        for (int i = 0; i < layers.Count; i++)
        {
            bool isPair = i + 1 < layers.Count && layers[i].ComputedWith == layers[i + 1].Name;
            int planes = layers[i].Planes + (isPair ? layers[i + 1].Planes : 0);
            if (pass.Count > 0 && pass.Sum(other => other.Planes) + planes > planesAtOnce)
            {
                yield return [.. pass];
                pass.Clear();
            }

            pass.Add(layers[i]);
            if (isPair)
            {
                pass.Add(layers[++i]);
            }
        }

        yield return [.. pass];
    }
}
