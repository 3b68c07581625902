using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The <see cref="DarkZone"/>s of the whole disc of the Sun and of parts of it. One object serves many frames and keeps its memory.
/// </summary>
internal sealed class DarkZones
{
    private const int Count = 8;

    private readonly DarkZone[] _zones = new DarkZone[Count];
    private readonly double[] _tops = new double[Count];
    private float[] _heights = [];

    /// <summary>The points from which the whole disc is hidden.</summary>
    public DarkZone Whole => _zones[0];

    /// <summary>Computes the zones of a frame.</summary>
    /// <param name="grid">The planes and columns.</param>
    /// <param name="lowest">Lowest height of all terrain in each plane and column, m.</param>
    /// <param name="solidRadius">Radius of the sphere that is solid everywhere, m.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    public void Compute(
        SectionGrid grid, ReadOnlyMemory<float> lowest, double solidRadius, double slope, int threads, CancellationToken cancellation)
    {
        int length = grid.Planes * grid.Columns;
        if (_heights.Length < Count * length)
        {
            _heights = new float[Count * length];
        }

        WorkerTeam.Run(threads, Count, (_, zone) =>
        {
            _tops[zone] = slope * (1.0 - (2.0 * zone / Count));
            _zones[zone] = new DarkZone(grid, lowest, solidRadius, slope, _tops[zone], _heights.AsMemory(zone * length, length));
        }, cancellation);
    }

    /// <summary>How far along u the disc is hidden from a point (m), over its distance; minus infinity if the zones tell nothing.</summary>
    public double HiddenUpTo(Vector3D point)
    {
        // Each zone lies in the next one.
        int first = 0;
        int end = Count;
        while (first < end)
        {
            int middle = (first + end) / 2;
            if (_zones[middle].Holds(point))
            {
                end = middle;
            }
            else
            {
                first = middle + 1;
            }
        }

        return first == Count ? double.NegativeInfinity : _tops[first];
    }
}
