using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>The outermost samples of a model, also those around its places without data. Immutable.</summary>
internal sealed class Outline
{
    private const int Side = DataGaps.Side;

    /// <summary>Tiles that are looked at, at least, of a model that has as many: 512 samples tell a mean.</summary>
    private const double LeastTiles = 16.0;

    private readonly ITerrainGrid _grid;
    private readonly DataGaps _gaps;
    private readonly int _columns;

    /// <summary>Reads them; of a model with gaps all samples are looked at.</summary>
    /// <param name="grid">The model, which is not of the whole Moon.</param>
    /// <param name="piece">Length of the pieces, m; at least two tiles of each are read.</param>
    public Outline(ITerrainGrid grid, double piece)
    {
        _grid = grid;
        GridWindow window = grid.Window;
        bool isRing = grid.Projection is Equirectangular && window.Samples == grid.Samples;
        _gaps = new DataGaps(grid, isRing);
        _columns = (window.Samples + Side - 1) / Side;
        int rows = (window.Lines + Side - 1) / Side;
        bool[] isBorder = new bool[_columns * rows];
        foreach (int tile in _gaps.TilesWithin(1))
        {
            isBorder[tile] = true;
        }

        for (int tile = 0; tile < isBorder.Length; tile++)
        {
            (int row, int column) = (tile / _columns, tile % _columns);
            isBorder[tile] |= row == 0 || row == rows - 1 || (!isRing && (column == 0 || column == _columns - 1));
        }

        const double TilesOfPiece = 2.0;
        int[] tiles = [.. Enumerable.Range(0, isBorder.Length).Where(tile => isBorder[tile])];
        double side = Side * grid.Projection.Resolution.MetresPerPixel;
        int step = Math.Max(1, (int)Math.Min(piece / (TilesOfPiece * side), tiles.Length / LeastTiles));
        step -= 1 - (step % 2); // an even one would take the left sides of lines of tiles only
        Samples = [.. tiles.Where((_, number) => number % step == 0).SelectMany(tile => In(tile, step))];
    }

    /// <summary>The samples, tile by tile.</summary>
    public IReadOnlyList<OutlineSample> Samples { get; }

    private List<OutlineSample> In(int tile, int step)
    {
        GridWindow window = _grid.Window;
        (int down, int right) = (tile / _columns * Side, tile % _columns * Side);
        bool[] outermost = _gaps.OutermostIn(down, right);
        List<OutlineSample> samples = [];
        double[] radius = new double[1];
        for (int at = 0; at < outermost.Length; at++)
        {
            (int line, int sample) = (window.FirstLine + down + (at / Side), window.FirstSample + right + (at % Side));
            if (outermost[at] && sample < window.EndSample)
            {
                _grid.ReadRadii(line, sample, radius);
                samples.Add(new OutlineSample(line, sample, _grid.Projection.DirectionOf(line, sample), radius[0], step));
            }
        }

        return samples;
    }
}

/// <summary>An outermost sample of a model.</summary>
/// <param name="Direction">Unit vector, body-fixed.</param>
/// <param name="Radius">m.</param>
/// <param name="Count">For how many samples it is.</param>
internal readonly record struct OutlineSample(int Line, int Sample, Vector3D Direction, double Radius, int Count);
