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

    /// <summary>Which samples of a tile have data, and beside them, along lines, samples or diagonals, a place without.</summary>
    /// <param name="firstDown">The tile's first line, from the model's first.</param>
    /// <param name="firstRight">Its first sample, from the model's first.</param>
    public bool[] OutermostIn(int firstDown, int firstRight)
    {
        bool[] outermost = new bool[Side * Side];
        for (int at = 0; at < outermost.Length; at++)
        {
            (int down, int right) = (firstDown + (at / Side), firstRight + (at % Side));
            outermost[at] = HasData(down, right) && !HaveData(down - 1, down + 1, right - 1, right + 1);
        }

        return outermost;
    }

    private bool HaveData(int firstDown, int lastDown, int firstRight, int lastRight)
    {
        for (int down = firstDown; down <= lastDown; down++)
        {
            for (int right = firstRight; right <= lastRight; right++)
            {
                if (!HasData(down, right))
                {
                    return false;
                }
            }
        }

        return true;
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
