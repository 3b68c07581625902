using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>
/// Computes a frame's layers, all rows in parallel. A few layers are computed at a time, so that memory does not grow with their number.
/// </summary>
internal static class LayerPasses
{
    /// <summary>
    /// Bytes of the layers of one pass. At 1024 x 1024 px all layers take four passes, so each pixel is looked up four times instead of
    /// once a layer.
    /// </summary>
    private const long MemoryOfAPass = 64L << 20;

    /// <summary>Computes layers and passes them on, one after the other.</summary>
    /// <param name="sampler">The frame.</param>
    /// <param name="layers">Which, in their order.</param>
    /// <param name="precision">Of their real numbers.</param>
    /// <param name="layout">Of their numbers in memory.</param>
    /// <param name="use">Gets each layer; its memory is used again afterwards.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Run(
        LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision, LayerLayout layout, Action<StoredLayer> use,
        CancellationToken cancellation)
    {
        long pixels = (long)sampler.Width * sampler.Height;
        foreach (Layer[] pass in Passes(layers, layer => pixels * layer.Planes * layer.StoredType(precision).Size()))
        {
            List<StoredLayer> stored = [];
            try
            {
                foreach (Layer layer in pass)
                {
                    stored.Add(new StoredLayer(layer, layer.StoredType(precision), layout, sampler.Width, sampler.Height));
                }

                Fill(sampler, pass, stored, cancellation);
                foreach (StoredLayer layer in stored)
                {
                    cancellation.ThrowIfCancellationRequested();
                    use(layer);
                }
            }
            finally
            {
                stored.ForEach(layer => layer.Dispose());
            }
        }
    }

    private static void Fill(
        LayerSampler sampler, Layer[] layers, List<StoredLayer> stored, CancellationToken cancellation) => Parallel.For(
        0,
        sampler.Height,
        new ParallelOptions { CancellationToken = cancellation, MaxDegreeOfParallelism = Environment.ProcessorCount },
        () => layers.SelectMany(layer => Enumerable.Range(0, layer.Planes)).Select(_ => new double[sampler.Width]).ToArray(),
        (row, _, planes) =>
        {
            sampler.SampleRow(row, layers, planes, start: 0);
            int next = 0;
            foreach (StoredLayer layer in stored)
            {
                for (int plane = 0; plane < layer.Layer.Planes; plane++)
                {
                    layer.Put(row, plane, planes[next++]);
                }
            }

            return planes;
        },
        static _ => { });

    /// <summary>As many layers at once as fit; one at least.</summary>
    private static IEnumerable<Layer[]> Passes(IReadOnlyList<Layer> layers, Func<Layer, long> bytesOf)
    {
        List<Layer> pass = [];
        foreach (Layer layer in layers)
        {
            if (pass.Count > 0 && pass.Sum(bytesOf) + bytesOf(layer) > MemoryOfAPass)
            {
                yield return [.. pass];
                pass.Clear();
            }

            pass.Add(layer);
        }

        yield return [.. pass];
    }
}
