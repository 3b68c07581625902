using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// A model inside coarser ones: along its border, and around places without data, its heights go over into the facets of the coarser ones.
/// Safe for several threads.
/// </summary>
/// <remarks>
/// With d, the number of samples from a sample to the nearest place without data (along lines, samples or diagonally), t = (d - 1) / width
/// up to 1, and w = t t (3 - 2 t), a radius is w times its own plus 1 - w times that of the coarser facets in its direction. So the
/// outermost samples, for which d is 1, lie on the coarser facets.
/// </remarks>
internal sealed class BorderBlend : ChangedGrid
{
    private const int Side = DataGaps.Side;

    /// <summary>Samples of the width at least, so that the slope of a step between the models is spread over some cells.</summary>
    private const int MinWidth = 8;

    /// <summary>Samples of the width at most: each costs a search in the coarser models.</summary>
    private const int MaxWidth = 64;

    private readonly CoarserGround _coarser;
    private readonly bool _isRing;
    private readonly int _columns;
    private readonly bool[] _isBlended;
    private readonly DataGaps _gaps;
    private readonly ConcurrentDictionary<int, Tile> _tiles = new();

    /// <summary>Prepares a model; of one with gaps all samples are looked at.</summary>
    /// <param name="grid">The model, which is not of the whole Moon.</param>
    /// <param name="widest">Samples of the border at most.</param>
    public BorderBlend(ITerrainGrid grid, CoarserGround coarser, int widest = MaxWidth)
        : base(grid)
    {
        _coarser = coarser;
        GridWindow window = grid.Window;
        _isRing = grid.Projection is Equirectangular && window.Samples == grid.Samples;
        Width = Math.Min(WidthOf(grid, coarser), widest);
        (double min, double max) = coarser.RadiusLimits;
        RadiusLimits = (Math.Min(min, grid.RadiusLimits.Min), Math.Max(max, grid.RadiusLimits.Max));
        _columns = (window.Samples + Side - 1) / Side;
        _isBlended = new bool[_columns * ((window.Lines + Side - 1) / Side)];
        _gaps = new DataGaps(grid, _isRing);
        foreach (int tile in _gaps.TilesWithin(Width))
        {
            _isBlended[tile] = true;
        }

        for (int tile = 0; tile < _isBlended.Length; tile++)
        {
            int down = tile / _columns * Side;
            int right = tile % _columns * Side;
            _isBlended[tile] |= down <= Width || down + Side + Width >= window.Lines
                || (!_isRing && (right <= Width || right + Side + Width >= window.Samples));
        }
    }

    /// <summary>Width of the border, in samples.</summary>
    public int Width { get; }

    /// <inheritdoc/>
    public override (double Min, double Max) RadiusLimits { get; }

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples)
    {
        int firstDown = firstLine - Window.FirstLine;
        int firstRight = firstSample - Window.FirstSample;
        for (int row = firstDown / Side; row <= (firstDown + lines - 1) / Side; row++)
        {
            for (int column = firstRight / Side; column <= (firstRight + samples - 1) / Side; column++)
            {
                if (column >= _columns || _isBlended[(row * _columns) + column])
                {
                    return null;
                }
            }
        }

        return Source.BoundsOf(firstLine, lines, firstSample, samples);
    }

    /// <inheritdoc/>
    public override void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        GridWindow window = Window;
        int down = line - window.FirstLine;
        for (int done = 0; done < radii.Length;)
        {
            int right = firstSample + done - window.FirstSample;
            right -= _isRing && right >= Samples ? Samples : 0;
            int tile = (down / Side * _columns) + (right / Side);
            int count = Math.Min(radii.Length - done, Math.Min(Side - (right % Side), window.Samples - right));
            ArgumentOutOfRangeException.ThrowIfLessThan(count, 1, nameof(firstSample));
            Span<double> part = radii.Slice(done, count);
            if (_isBlended[tile])
            {
                ReadBlended(_tiles.GetOrAdd(tile, NewTile), down, right, part);
            }
            else
            {
                Source.ReadRadii(line, window.FirstSample + right, part);
            }

            done += count;
        }
    }

    /// <inheritdoc/>
    public override bool IsBlended(int line, int sample)
    {
        (int down, int right) = (line - Window.FirstLine, sample - Window.FirstSample);
        right = Projection is Equirectangular ? (right + Samples) % Samples : right; // over the prime meridian
        int tile = (down / Side * _columns) + (right / Side);
        return _isBlended[tile] && _tiles.GetOrAdd(tile, NewTile).Distances[(down % Side * Side) + (right % Side)] <= Width;
    }

    /// <summary>A cell of the coarser model around the middle of this one, in its own samples, within limits.</summary>
    private static int WidthOf(ITerrainGrid grid, CoarserGround coarser)
    {
        GridWindow window = grid.Window;
        Vector3D middle = grid.Projection.DirectionOf(
            0.5 * (window.FirstLine + window.EndLine - 1), 0.5 * (window.FirstSample + window.EndSample - 1));
        double ratio = coarser.CellAngleAt(middle) * MoonConstants.ReferenceRadius / grid.Projection.Resolution.MetresPerPixel;
        int width = Math.Clamp((int)Math.Ceiling(ratio), MinWidth, MaxWidth);
        return Math.Clamp(Math.Min(window.Lines, window.Samples) / 4, 1, width);
    }

    private Tile NewTile(int tile)
    {
        double[] radii = new double[Side * Side];
        Array.Fill(radii, double.NaN);
        return new Tile(radii, DistancesIn(tile, Width));
    }

    private byte[] DistancesIn(int tile, int width) => _gaps.DistancesAround(tile / _columns * Side, tile % _columns * Side, width);

    /// <summary>Each sample is computed when it is first read: a seam needs the outermost ones only. Threads compute the same.</summary>
    private void ReadBlended(Tile tile, int down, int right, Span<double> radii)
    {
        int start = (down % Side * Side) + (right % Side);
        for (int i = 0; i < radii.Length; i++)
        {
            ref double known = ref tile.Radii[start + i];
            double radius = Volatile.Read(ref known);
            if (double.IsNaN(radius))
            {
                radius = Blend(Window.FirstLine + down, Window.FirstSample + right + i, tile.Distances[start + i]);
                Volatile.Write(ref known, radius);
            }

            radii[i] = radius;
        }
    }

    private double Blend(int line, int sample, int distance)
    {
        double t = Math.Clamp((distance - 1) / (double)Width, 0.0, 1.0);
        double weight = t * t * (3.0 - (2.0 * t));
        Span<double> own = stackalloc double[1];
        own[0] = 0.0;
        if (weight > 0.0)
        {
            Source.ReadRadii(line, sample, own);
        }

        return weight < 1.0
            ? (weight * own[0]) + ((1.0 - weight) * _coarser.RadiusAt(Projection.DirectionOf(line, sample)))
            : own[0];
    }

    /// <summary>Samples of a tile that are known, the others NaN, and their distances from places without data.</summary>
    private sealed record Tile(double[] Radii, byte[] Distances);
}
