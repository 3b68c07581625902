using Msisf.Core.Camera;
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

    /// <summary>Computes all layers of some rows at a time, from the top: the frame is drawn once, and never kept as a whole.</summary>
    /// <param name="sampler">The frame.</param>
    /// <param name="layers">Which, in their order.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="layout">Layout of their numbers in memory.</param>
    /// <param name="use">Gets the number of the first row, and these rows of each layer; their memory is used again afterwards.</param>
    /// <param name="cancellation">Stops between rows.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void RunInBands(
        LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision, LayerLayout layout,
        Action<int, IReadOnlyList<StoredLayer>> use, CancellationToken cancellation)
    {
        for (int first = 0; first < sampler.Height; first += sampler.RowsAtOnce)
        {
            int rows = Math.Min(sampler.RowsAtOnce, sampler.Height - first);
            Store(sampler, layers, precision, layout, new PixelRows(first, first + rows), stored => use(first, stored), cancellation);
        }
    }

    /// <summary>Computes layers and passes them on, one after the other.</summary>
    /// <param name="sampler">The frame.</param>
    /// <param name="layers">Which, in their order.</param>
    /// <param name="precision">Precision of their real numbers.</param>
    /// <param name="layout">Layout of their numbers in memory.</param>
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
            Store(sampler, pass, precision, layout, new PixelRows(0, sampler.Height), Use, cancellation);
        }

        void Use(IReadOnlyList<StoredLayer> stored)
        {
            foreach (StoredLayer layer in stored)
            {
                cancellation.ThrowIfCancellationRequested();
                use(layer);
            }
        }
    }

    private static void Store(
        LayerSampler sampler, IReadOnlyList<Layer> layers, LayerPrecision precision, LayerLayout layout, PixelRows rows,
        Action<IReadOnlyList<StoredLayer>> use, CancellationToken cancellation)
    {
        List<StoredLayer> stored = [];
        try
        {
            foreach (Layer layer in layers)
            {
                stored.Add(new StoredLayer(layer, layer.StoredType(precision), layout, sampler.Width, rows.End - rows.First));
            }

            Fill(sampler, layers, stored, rows, cancellation);
            use(stored);
        }
        finally
        {
            stored.ForEach(layer => layer.Dispose());
        }
    }

    private static void Fill(
        LayerSampler sampler, IReadOnlyList<Layer> layers, List<StoredLayer> stored, PixelRows rows,
        CancellationToken cancellation) => Parallel.For(
        rows.First,
        rows.End,
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
                    layer.Put(row - rows.First, plane, planes[next++]);
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
