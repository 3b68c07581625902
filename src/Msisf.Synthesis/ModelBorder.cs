using System.Collections.Concurrent;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The border of a map of a part of the Moon: where the map has data its ground is its own, and beyond, within two samples, it goes over
/// into that of the coarser models. Safe for several threads.
/// </summary>
internal sealed class ModelBorder
{
    private const int Side = DataGaps.Side;

    /// <summary>Samples from the nearest one with data where the map counts for nothing.</summary>
    private const int Beyond = 2;

    /// <summary>Up to this distance from samples with data, in samples, the map counts fully: their cells' corners have 0.75.</summary>
    private const double Within = 0.75;

    private readonly ITerrainGrid _model;
    private readonly bool _isAround;
    private readonly ConcurrentDictionary<int, byte[]> _distances = new();
    private readonly int _columns;

    /// <summary>Takes a map.</summary>
    /// <param name="model">The map.</param>
    public ModelBorder(ITerrainGrid model)
    {
        _model = model;
        _isAround = model.Projection is Equirectangular && model.Window.Samples == model.Samples;
        _columns = (model.Window.Samples + (2 * Beyond) + Side - 1) / Side;
    }

    /// <summary>The weight at a place: 1 where the map has data, 0 beyond its border.</summary>
    /// <param name="line">px from the centre of the first line.</param>
    /// <param name="sample">px from the centre of the first sample.</param>
    public double WeightAt(double line, double sample)
    {
        GridWindow window = _model.Window;
        double down = line - window.FirstLine;
        double right = RightOf(sample);
        bool isNear = down > -Beyond && down < window.Lines - 1 + Beyond
            && (_isAround || (right > -Beyond && right < window.Samples - 1 + Beyond));
        if (!isNear)
        {
            return 0.0;
        }

        (int row, int column) = ((int)Math.Floor(down), (int)Math.Floor(right));
        (double v, double u) = (down - row, right - column);
        double distance = ((1.0 - v) * (((1.0 - u) * At(row, column)) + (u * At(row, column + 1))))
            + (v * (((1.0 - u) * At(row + 1, column)) + (u * At(row + 1, column + 1))));
        double t = Math.Clamp((Beyond - distance) / (Beyond - Within), 0.0, 1.0);
        return t * t * (3.0 - (2.0 * t));
    }

    /// <summary>Whether the map has data at a sample, which may lie beside it.</summary>
    /// <param name="line">Counted as the map's lines.</param>
    /// <param name="sample">Counted as its samples.</param>
    public bool HasData(int line, int sample)
    {
        int row = line - _model.Window.FirstLine;
        return row >= -Beyond && row < _model.Window.Lines + Beyond && At(row, (int)RightOf(sample)) == 0;
    }

    /// <summary>Samples from the left edge of the map's window; a map over the prime meridian goes on there.</summary>
    private double RightOf(double sample)
    {
        GridWindow window = _model.Window;
        double right = sample - window.FirstSample;
        return _model.Projection is not Equirectangular ? right
            : right < -Beyond ? right + _model.Samples
            : right >= window.Samples - 1 + Beyond && right - _model.Samples > -Beyond ? right - _model.Samples : right;
    }

    /// <summary>Samples to the nearest one with data, along lines, samples or diagonals, up to <see cref="Beyond"/>.</summary>
    private int At(int down, int right)
    {
        GridWindow window = _model.Window;
        right = _isAround ? (right + window.Samples) % window.Samples : right;
        int above = Math.Max(-down, down - (window.Lines - 1));
        int beside = _isAround ? 0 : Math.Max(-right, right - (window.Samples - 1));
        int outside = Math.Max(0, Math.Max(above, beside));
        if (outside >= Beyond || !_model.MayHaveGaps)
        {
            return Math.Min(outside, Beyond);
        }

        (int row, int column) = (down + Beyond, right + Beyond);
        byte[] tile = _distances.GetOrAdd((row / Side * _columns) + (column / Side), TileOf);
        return tile[(row % Side * Side) + (column % Side)];
    }

    private byte[] TileOf(int tile)
    {
        const int Wide = Side + (2 * Beyond);
        (int top, int left) = ((tile / _columns * Side) - Beyond, (tile % _columns * Side) - Beyond);
        bool[] hasData = new bool[Wide * Wide];
        Span<bool> gap = stackalloc bool[1];
        for (int i = 0; i < hasData.Length; i++)
        {
            GridWindow window = _model.Window;
            (int down, int right) = (top - Beyond + (i / Wide), left - Beyond + (i % Wide));
            right = _isAround ? (right + window.Samples) % window.Samples : right;
            if (down >= 0 && down < window.Lines && right >= 0 && right < window.Samples)
            {
                _model.ReadGaps(window.FirstLine + down, window.FirstSample + right, gap);
                hasData[i] = !gap[0];
            }
        }

        byte[] distances = new byte[Side * Side];
        for (int i = 0; i < distances.Length; i++)
        {
            int at = ((Beyond + (i / Side)) * Wide) + Beyond + (i % Side);
            distances[i] = hasData[at] ? (byte)0 : hasData[at - 1] || hasData[at + 1]
                || hasData.AsSpan(at - Wide - 1, 3).Contains(true) || hasData.AsSpan(at + Wide - 1, 3).Contains(true) ? (byte)1
                : (byte)Beyond;
        }

        return distances;
    }
}
