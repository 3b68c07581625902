using System.Runtime.CompilerServices;

namespace Msisf.Core.Render.Photometry;

/// <summary>Reads a level of a map between its pixels; <c>default</c> must not be read.</summary>
internal readonly ref struct MapLevelReader
{
    private readonly ReadOnlySpan<ushort> _codes;
    private readonly MapExtent _extent;
    private readonly int _width;
    private readonly int _height;
    private readonly double _scaleX;
    private readonly double _scaleY;

    public MapLevelReader(AlbedoMap map, int level)
    {
        AlbedoMapLevel finest = map.Levels[0];
        AlbedoMapLevel wanted = map.Levels[level];
        _codes = wanted.Codes.Span;
        _extent = map.Extent;
        (_width, _height) = (wanted.Width, wanted.Height);
        (_scaleX, _scaleY) = ((double)wanted.Width / finest.Width, (double)wanted.Height / finest.Height);
    }

    /// <summary>
    /// The code at a place, linear between the middles of pixels; 0 if there is no data. Where some pixels round the place have none, the
    /// others count.
    /// </summary>
    /// <param name="finestX">Distance from the left edge, pixels of the finest level.</param>
    /// <param name="finestY">Distance from the upper edge, pixels of the finest level.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double At(double finestX, double finestY)
    {
        double x = (finestX * _scaleX) - 0.5;
        double y = (finestY * _scaleY) - 0.5;
        int column = (int)x; // rounds towards 0, which is down but at the western and northern edge
        int row = (int)y;
        if (x < 0.0 || y < 0.0 || column >= _width - 1 || row >= _height - 1)
        {
            return AtEdge(x, y);
        }

        double partX = x - column;
        double partY = y - row;

        int index = (row * _width) + column;
        ReadOnlySpan<ushort> here = _codes.Slice(index, 2);
        ReadOnlySpan<ushort> below = _codes.Slice(index + _width, 2);
        int northWest = here[0];
        int northEast = here[1];
        int southWest = below[0];
        int southEast = below[1];
        if (northWest != 0 && northEast != 0 && southWest != 0 && southEast != 0)
        {
            double north = northWest + (partX * (northEast - northWest));
            double south = southWest + (partX * (southEast - southWest));
            return north + (partY * (south - north));
        }

        return AtGap(northWest, northEast, southWest, southEast, partX, partY);
    }

    /// <summary>Where a pixel has no data.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double AtGap(int northWest, int northEast, int southWest, int southEast, double partX, double partY) =>
        Mix(RowMean(northWest, northEast, partX), RowMean(southWest, southEast, partX), partY);

    /// <summary>Across the seam of a full circle, over a pole, or at the edge of a map that shows a part of the Moon.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private double AtEdge(double x, double y)
    {
        double upper = Math.Floor(y);
        return Mix(InRow(x, (int)upper), InRow(x, (int)upper + 1), y - upper);
    }

    private (double Code, double Weight) InRow(double x, int row)
    {
        // Half a turn round the pole: the row beyond it is the row before it, on the other side.
        if (row < 0)
        {
            return _extent.ReachesNorthPole ? InRow(x + (0.5 * _width), -1 - row) : default;
        }

        if (row >= _height)
        {
            return _extent.ReachesSouthPole ? InRow(x + (0.5 * _width), (2 * _height) - 1 - row) : default;
        }

        int column = (int)Math.Floor(x);
        double part = x - column;
        return RowMean(CodeAt(column, row), CodeAt(column + 1, row), part);
    }

    private int CodeAt(int column, int row)
    {
        if (_extent.IsFullCircle)
        {
            column %= _width;
            column = column < 0 ? column + _width : column;
        }

        return (uint)column < (uint)_width ? _codes[(row * _width) + column] : 0;
    }

    private static (double Code, double Weight) RowMean(int west, int east, double part)
    {
        double weightWest = west == 0 ? 0.0 : 1.0 - part;
        double weightEast = east == 0 ? 0.0 : part;
        double weight = weightWest + weightEast;
        return weight > 0.0 ? (((weightWest * west) + (weightEast * east)) / weight, weight) : default;
    }

    private static double Mix((double Code, double Weight) north, (double Code, double Weight) south, double part)
    {
        double weightNorth = north.Weight * (1.0 - part);
        double weightSouth = south.Weight * part;
        double weight = weightNorth + weightSouth;
        return weight > 0.0 ? ((weightNorth * north.Code) + (weightSouth * south.Code)) / weight : 0.0;
    }
}
