using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>The samples of a model that have no data, and what lies beyond its sides. Immutable.</summary>
internal sealed class DataGaps
{
    /// <summary>Lines and samples of a tile.</summary>
    public const int Side = 32;

    private readonly GridWindow _window;
    private readonly bool _isRing;
    private readonly int _rows;
    private readonly int _columns;
    private readonly Dictionary<int, bool[]> _gaps = [];

    /// <summary>Looks for the samples; of a model that may have some all are looked at.</summary>
    /// <param name="isRing">Whether its last sample of a line lies beside the first.</param>
    public DataGaps(ITerrainGrid grid, bool isRing)
    {
        (_window, _isRing) = (grid.Window, isRing);
        _rows = (_window.Lines + Side - 1) / Side;
        _columns = (_window.Samples + Side - 1) / Side;
        if (!grid.MayHaveGaps)
        {
            return;
        }

        bool[] gaps = new bool[_window.Samples];
        for (int down = 0; down < _window.Lines; down++)
        {
            if (down % Side == 0 && !grid.MayHaveGapsIn(
                _window.FirstLine + down, Math.Min(Side, _window.Lines - down), _window.FirstSample, _window.Samples))
            {
                down += Side - 1;
                continue;
            }

            grid.ReadGaps(_window.FirstLine + down, _window.FirstSample, gaps);
            for (int right = Array.IndexOf(gaps, true); right >= 0; right = Array.IndexOf(gaps, true, right + 1))
            {
                int tile = TileOf(down, right);
                if (!_gaps.TryGetValue(tile, out bool[]? inTile))
                {
                    _gaps[tile] = inTile = new bool[Side * Side];
                }

                inTile[PlaceOf(down, right)] = true;
            }
        }
    }

    /// <summary>The tiles with a sample up to a distance, and some more, from one without data.</summary>
    public IEnumerable<int> TilesWithin(int distance)
    {
        int reach = (distance + Side - 1) / Side;
        foreach (int tile in _gaps.Keys)
        {
            (int middleRow, int middleColumn) = (tile / _columns, tile % _columns);
            for (int row = Math.Max(0, middleRow - reach); row <= Math.Min(_rows - 1, middleRow + reach); row++)
            {
                for (int column = middleColumn - reach; column <= middleColumn + reach; column++)
                {
                    int wrapped = _isRing ? (column + _columns) % _columns : column;
                    if (wrapped >= 0 && wrapped < _columns)
                    {
                        yield return (row * _columns) + wrapped;
                    }
                }
            }
        }
    }

    /// <summary>
    /// Number of samples from each sample of a tile to the nearest place without data, along lines, samples or diagonals; 0 for one without
    /// data itself. More than one beyond the width is not told apart.
    /// </summary>
    /// <param name="firstDown">The tile's first line, from the model's first.</param>
    /// <param name="firstRight">Its first sample, from the model's first.</param>
    public byte[] DistancesAround(int firstDown, int firstRight, int width) =>
        _gaps.Count == 0 ? DistancesFromSides(firstDown, firstRight, width) : DistancesFromGaps(firstDown, firstRight, width);

    private byte[] DistancesFromSides(int firstDown, int firstRight, int width)
    {
        byte[] own = new byte[Side * Side];
        for (int row = 0; row < Side; row++)
        {
            int vertical = Math.Min(firstDown + row + 1, _window.Lines - firstDown - row);
            for (int column = 0; column < Side; column++)
            {
                int right = firstRight + column;
                int distance = _isRing ? vertical : Math.Min(vertical, Math.Min(right + 1, _window.Samples - right));
                own[(row * Side) + column] = (byte)Math.Clamp(distance, 0, width + 1);
            }
        }

        return own;
    }

    private byte[] DistancesFromGaps(int firstDown, int firstRight, int width)
    {
        int around = width + 1;
        int side = Side + (2 * around);
        byte[] distances = new byte[side * side];
        for (int row = 0; row < side; row++)
        {
            for (int column = 0; column < side; column++)
            {
                At(row, column) = HasData(firstDown + row - around, firstRight + column - around) ? (byte)around : (byte)0;
            }
        }

        for (int row = 0; row < side; row++)
        {
            for (int column = 0; column < side; column++)
            {
                Lower(row, column, row, column - 1);
                Lower(row, column, row - 1, column - 1);
                Lower(row, column, row - 1, column);
                Lower(row, column, row - 1, column + 1);
            }
        }

        for (int row = side - 1; row >= 0; row--)
        {
            for (int column = side - 1; column >= 0; column--)
            {
                Lower(row, column, row, column + 1);
                Lower(row, column, row + 1, column + 1);
                Lower(row, column, row + 1, column);
                Lower(row, column, row + 1, column - 1);
            }
        }

        byte[] own = new byte[Side * Side];
        for (int row = 0; row < Side; row++)
        {
            distances.AsSpan(((row + around) * side) + around, Side).CopyTo(own.AsSpan(row * Side));
        }

        return own;

        ref byte At(int row, int column) => ref distances[(row * side) + column];

        void Lower(int row, int column, int besideRow, int besideColumn)
        {
            if (besideRow >= 0 && besideRow < side && besideColumn >= 0 && besideColumn < side)
            {
                At(row, column) = (byte)Math.Min(At(row, column), At(besideRow, besideColumn) + 1);
            }
        }
    }

    private static int PlaceOf(int down, int right) => (down % Side * Side) + (right % Side);

    private int TileOf(int down, int right) => (down / Side * _columns) + (right / Side);

    private bool HasData(int down, int right)
    {
        right = _isRing ? (right + _window.Samples) % _window.Samples : right;
        return down >= 0 && down < _window.Lines && right >= 0 && right < _window.Samples
            && !(_gaps.TryGetValue(TileOf(down, right), out bool[]? inTile) && inTile[PlaceOf(down, right)]);
    }
}
