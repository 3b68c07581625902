using System.Collections.Concurrent;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// How much a map of a part of the Moon counts at a place: 1 inside, and less along its borders and around places without data, where the
/// ground goes over into that of the coarser models. Safe for several threads.
/// </summary>
internal sealed class ModelBorder
{
    private const int Side = DataGaps.Side;
    private const int LeastWidth = 8; // samples
    private const int MostWidth = 64;

    /// <summary>Distance from a place without data at which a cubic through 4 x 4 samples has all of them, in samples.</summary>
    private const double WithoutWeight = 2.0;

    private readonly ITerrainGrid _model;
    private readonly DataGaps _gaps;
    private readonly bool _isRing;
    private readonly int _width;
    private readonly int _columns;
    private readonly ConcurrentDictionary<int, byte[]> _distances = new();

    /// <summary>Takes a map.</summary>
    /// <param name="model">The map.</param>
    /// <param name="coarserSpacing">m between the samples of the next coarser model.</param>
    public ModelBorder(ITerrainGrid model, double coarserSpacing)
    {
        _model = model;
        GridWindow window = model.Window;
        _isRing = model.Projection is Equirectangular && window.Samples == model.Samples;
        _gaps = new DataGaps(model, _isRing);
        _columns = (window.Samples + Side - 1) / Side;
        double ratio = coarserSpacing / model.Projection.Resolution.MetresPerPixel;
        _width = Math.Clamp(
            Math.Min(window.Lines, window.Samples) / 4, 1, Math.Clamp((int)Math.Ceiling(ratio), LeastWidth, MostWidth));
    }

    /// <summary>The weight at a place of the map, 0 to 1; 0 beside it.</summary>
    /// <param name="line">px from the centre of the first line.</param>
    /// <param name="sample">px from the centre of the first sample.</param>
    public double WeightAt(double line, double sample)
    {
        GridWindow window = _model.Window;
        sample += _isRing && sample < 0.0 ? _model.Samples : 0;
        double down = line - window.FirstLine;
        double right = sample - window.FirstSample;
        right += !_isRing && _model.Projection is Equirectangular && right < 0.0 ? _model.Samples : 0;
        if (!(down >= 0.0 && down < window.Lines - 1 && right >= 0.0 && right < window.Samples - (_isRing ? 0 : 1)))
        {
            return 0.0;
        }

        (int row, int column) = ((int)down, (int)right);
        (double v, double u) = (down - row, right - column);
        double distance = ((1.0 - v) * (((1.0 - u) * At(row, column)) + (u * At(row, column + 1))))
            + (v * (((1.0 - u) * At(row + 1, column)) + (u * At(row + 1, column + 1))));
        double t = Math.Clamp((distance - WithoutWeight) / _width, 0.0, 1.0);
        return t * t * (3.0 - (2.0 * t));
    }

    /// <summary>Samples to the nearest place without data, up to the width of the border and a little more.</summary>
    private int At(int down, int right)
    {
        right -= _isRing && right >= _model.Samples ? _model.Samples : 0;
        byte[] tile = _distances.GetOrAdd(
            (down / Side * _columns) + (right / Side),
            tile => _gaps.DistancesAround(tile / _columns * Side, tile % _columns * Side, _width + (int)WithoutWeight));
        return tile[(down % Side * Side) + (right % Side)];
    }
}
