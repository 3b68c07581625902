using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>Computes a frame's layers, all rows in parallel, a few layers at a time so that memory does not grow with their number.</summary>
internal static class LayerPasses
{
    /// <summary>bytes of planes in a pass: at 1024 x 1024 px all layers take three passes, so a pixel is looked up three times, not seventeen.</summary>
    private const long MemoryOfAPass = 64L << 20;

    /// <summary>Computes layers and hands them on, one after the other.</summary>
    /// <param name="sampler">The frame.</param>
    /// <param name="layers">Which, in their order.</param>
    /// <param name="use">Gets a layer and its planes, as <see cref="LayerSampler.SampleRow"/> fills them; they are filled anew afterwards.</param>
    /// <param name="cancellation">Stops between rows and between layers.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Run(
        LayerSampler sampler, IReadOnlyList<Layer> layers, Action<Layer, IReadOnlyList<double[]>> use, CancellationToken cancellation)
    {
        int pixels = checked(sampler.Width * sampler.Height);
        long planesAtOnce = Math.Max(1, MemoryOfAPass / sizeof(double) / pixels);
        List<double[]> pool = [];
        int next = 0;
        while (next < layers.Count)
        {
            List<Layer> pass = [layers[next]];
            while (next + pass.Count < layers.Count && pass.Sum(layer => layer.Planes) + layers[next + pass.Count].Planes <= planesAtOnce)
            {
                pass.Add(layers[next + pass.Count]);
            }

            while (pool.Count < pass.Sum(layer => layer.Planes))
            {
                pool.Add(new double[pixels]);
            }

            Parallel.For(
                0, sampler.Height, new ParallelOptions { CancellationToken = cancellation }, row => sampler.SampleRow(row, pass, pool));
            int firstPlane = 0;
            foreach (Layer layer in pass)
            {
                cancellation.ThrowIfCancellationRequested();
                use(layer, pool.GetRange(firstPlane, layer.Planes));
                firstPlane += layer.Planes;
            }

            next += pass.Count;
        }
    }
}
