namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Makes the next coarser level of a map from its rows, one after the other from north to south: each pixel is the mean of its area on the
/// sphere, also where the size is odd. Pixels without data (NaN) do not count.
/// </summary>
public sealed class MapReducer
{
    private readonly int _width;
    private readonly int _height;
    private readonly double _north;
    private readonly double _rowAngle;
    private readonly int[] _firstColumns;
    private readonly double[] _columnWeights;
    private readonly double[] _sums;
    private readonly double[] _weights;
    private readonly float[] _finished;
    private readonly Action<int, ReadOnlySpan<float>> _completed;

    /// <summary>Prepares a level.</summary>
    /// <param name="width">Pixels of the finer level from west to east.</param>
    /// <param name="height">Pixels of the finer level from north to south.</param>
    /// <param name="extent">What the map shows.</param>
    /// <param name="completed">Gets the index and the values of each row of the coarser level.</param>
    public MapReducer(int width, int height, MapExtent extent, Action<int, ReadOnlySpan<float>> completed)
    {
        (Width, Height) = AlbedoMapLevel.Below(width, height);
        (_width, _height) = (width, height);
        _north = extent.North;
        _rowAngle = extent.Height / height;
        _completed = completed;
        _firstColumns = new int[Width];
        _columnWeights = new double[3 * Width];
        _sums = new double[Width];
        _weights = new double[Width];
        _finished = new float[Width];
        for (int column = 0; column < Width; column++)
        {
            double start = (double)column * width / Width;
            double end = (column + 1.0) * width / Width;
            _firstColumns[column] = (int)start;
            for (int k = 0; k < 3; k++)
            {
                double west = Math.Max(start, _firstColumns[column] + k);
                double east = Math.Min(end, Math.Min(_firstColumns[column] + k + 1, width));
                _columnWeights[(3 * column) + k] = Math.Max(0.0, east - west);
            }
        }
    }

    /// <summary>Pixels of the coarser level from west to east.</summary>
    public int Width { get; }

    /// <summary>Pixels of the coarser level from north to south.</summary>
    public int Height { get; }

    /// <summary>Takes the next row of the finer level.</summary>
    /// <param name="row">Its index, from 0, each in turn.</param>
    /// <param name="values">Its values; NaN where there are none.</param>
    public void Add(int row, ReadOnlySpan<float> values)
    {
        double area = Math.Max(Math.Cos(_north - ((row + 0.5) * _rowAngle)), double.Epsilon);
        double start = (double)row * Height / _height;
        double end = (row + 1.0) * Height / _height;
        int upper = Math.Min((int)start, Height - 1);
        double border = upper + 1.0;
        bool isLast = row == _height - 1;
        if (end < border && !isLast)
        {
            Accumulate(values, area * (end - start));
            return;
        }

        Accumulate(values, area * (Math.Min(end, border) - start));
        Complete(upper);
        if (!isLast && end > border)
        {
            Accumulate(values, area * (end - border));
        }
    }

    private void Accumulate(ReadOnlySpan<float> values, double weight)
    {
        for (int column = 0; column < Width; column++)
        {
            int first = _firstColumns[column];
            double sum = 0.0;
            double total = 0.0;
            for (int k = 0; k < 3 && first + k < _width; k++)
            {
                double part = _columnWeights[(3 * column) + k];
                float value = values[first + k];
                if (!float.IsNaN(value))
                {
                    sum += part * value;
                    total += part;
                }
            }

            _sums[column] += weight * sum;
            _weights[column] += weight * total;
        }
    }

    private void Complete(int row)
    {
        for (int column = 0; column < Width; column++)
        {
            _finished[column] = _weights[column] > 0.0 ? (float)(_sums[column] / _weights[column]) : float.NaN;
        }

        Array.Clear(_sums);
        Array.Clear(_weights);
        _completed(row, _finished);
    }
}
