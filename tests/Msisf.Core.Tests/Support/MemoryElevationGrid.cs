using System.Buffers.Binary;
using Msisf.Core.Terrain;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Support;

/// <summary>A model in memory, for tests that must not depend on the program's own reader.</summary>
internal sealed class MemoryElevationGrid : IGlobalGrid
{
    private readonly float[] _radii;
    private readonly Lazy<(double Min, double Max)> _limits;

    /// <param name="productId">Name of the model.</param>
    /// <param name="pixelsPerDegree">Samples a degree.</param>
    /// <param name="radius">m, by line and sample; kept as float, which is exact for steps of 0.125 m.</param>
    public MemoryElevationGrid(string productId, int pixelsPerDegree, Func<int, int, double> radius)
    {
        ProductId = productId;
        PixelsPerDegree = pixelsPerDegree;
        _radii = new float[180 * pixelsPerDegree * Samples];
        for (int index = 0; index < _radii.Length; index++)
        {
            _radii[index] = (float)radius(index / Samples, index % Samples);
        }

        _limits = new Lazy<(double, double)>(() => (_radii.Min(), _radii.Max()));
    }

    public string ProductId { get; }

    public int PixelsPerDegree { get; }

    /// <summary>As tight as can be: what a renderer leaves out by them must be out of sight.</summary>
    public (double Min, double Max) RadiusLimits => _limits.Value;

    private int Samples => 360 * PixelsPerDegree;

    /// <summary>The real LDEM_4: 720 lines of 1440 little-endian 16-bit numbers in steps of 0.5 m over 1737400 m (its label).</summary>
    public static MemoryElevationGrid Ldem4()
    {
        byte[] image = File.ReadAllBytes(Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"));
        return new MemoryElevationGrid(
            "LDEM_4",
            4,
            (line, sample) => 1_737_400.0 + (0.5 * BinaryPrimitives.ReadInt16LittleEndian(image.AsSpan(2 * ((line * 1440) + sample)))));
    }

    /// <summary>A copy of another model, for one that is slow to ask.</summary>
    public static MemoryElevationGrid Of(IGlobalGrid grid)
    {
        double[] radius = new double[1];
        return new MemoryElevationGrid(grid.ProductId, grid.PixelsPerDegree, (line, sample) =>
        {
            grid.ReadRadii(line, sample, radius);
            return radius[0];
        });
    }

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        int start = line * Samples;
        for (int index = 0, sample = firstSample; index < radii.Length; index++, sample++)
        {
            sample = sample == Samples ? 0 : sample;
            radii[index] = _radii[start + sample];
        }
    }
}
