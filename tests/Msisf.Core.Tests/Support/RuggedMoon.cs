using Msisf.Core.Terrain;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Core.Tests.Support;

/// <summary>A made-up Moon with 40 km of relief at 2 px/deg: where the real one hides a little, this one hides much.</summary>
public sealed class RuggedMoon
{
    private const int Rows = 120;
    private const int Columns = 240;

    public RuggedMoon()
    {
        Random random = new(20120222);
        double[] peaks = new double[Rows * Columns];
        for (int peak = 0; peak < peaks.Length; peak++)
        {
            peaks[peak] = random.NextDouble() * random.NextDouble();
        }

        MemoryElevationGrid grid = new("RUGGED", 2, (line, sample) => 1_717_500.0 + (39_800.0 * Between(peaks, line / 3.0, sample / 3.0)));
        Grid = grid;
        Selection = new Dspsa(grid);
        Moon = new BruteForceMoon(grid);
    }

    public IGlobalGrid Grid { get; }

    public Dspsa Selection { get; }

    internal BruteForceMoon Moon { get; }

    private static double Between(double[] peaks, double row, double column)
    {
        int row0 = Math.Min((int)row, Rows - 2);
        int column0 = (int)column;
        int column1 = (column0 + 1) % Columns;
        double south = Math.Min(row - row0, 1.0);
        double east = column - column0;
        double North(int r) => ((1.0 - east) * peaks[(r * Columns) + column0]) + (east * peaks[(r * Columns) + column1]);
        return ((1.0 - south) * North(row0)) + (south * North(row0 + 1));
    }
}
