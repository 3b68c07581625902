namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// The edges of tiles along one axis. Labels round edges to parts of a pixel, so edges that nearly meet are one; where it lies to whole
/// pixels follows from the sizes of the tiles that end there.
/// </summary>
internal sealed class MapTileEdges
{
    /// <summary>
    /// Pixels: edges nearer than this are one. A tile's rounded size can make more than half a pixel, a missing line is a whole one.
    /// </summary>
    public const double Tolerance = 0.75;

    private MapTileEdges(double[] values, int[] positions, (int First, int End)[] tiles) =>
        (Values, Positions, Tiles) = (values, positions, tiles);

    /// <summary>The edges as the labels have them, pixels, in order.</summary>
    public double[] Values { get; }

    /// <summary>The edges to whole pixels, from 0.</summary>
    public int[] Positions { get; }

    /// <summary>For each tile the numbers of its first edge and of the edge at its end.</summary>
    public (int First, int End)[] Tiles { get; }

    /// <summary>Finds the edges of tiles.</summary>
    /// <param name="tiles">Beginning and size of each, pixels.</param>
    public static MapTileEdges Of((double Start, int Size)[] tiles)
    {
        List<double> values = [];
        foreach (double value in tiles.SelectMany(tile => (double[])[tile.Start, tile.Start + tile.Size]).Order())
        {
            if (values.Count == 0 || value > values[^1] + Tolerance)
            {
                values.Add(value);
            }
        }

        int EdgeAt(double value) => values.FindLastIndex(edge => edge <= value);
        (int First, int End)[] edges = [.. tiles.Select(tile => (EdgeAt(tile.Start), EdgeAt(tile.Start + tile.Size)))];
        int[] positions = new int[values.Count];
        for (int edge = 1; edge < positions.Length; edge++)
        {
            int ending = Array.FindIndex(edges, tile => tile.End == edge);
            positions[edge] = ending >= 0
                ? positions[edges[ending].First] + tiles[ending].Size
                : positions[edge - 1] + (int)Math.Round(values[edge] - values[edge - 1]);
        }

        return new MapTileEdges([.. values], positions, edges);
    }
}
