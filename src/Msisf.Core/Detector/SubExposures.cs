namespace Msisf.Core.Detector;

/// <summary>
/// The instants for which a frame is drawn to sum up its exposure, and what part of each row's light each of them stands for. They lie in
/// the middle of equal parts of the time in which the shutter is open anywhere. Immutable.
/// </summary>
public sealed class SubExposures
{
    private readonly double _exposureTime;
    private readonly double _lineTime;
    private readonly double _span;

    internal SubExposures(int count, double exposureTime, double lineTime, int height)
    {
        (Count, Height, _exposureTime, _lineTime) = (count, height, exposureTime, lineTime);
        _span = exposureTime + (lineTime * (height - 1));
    }

    /// <summary>How many; odd, so that one of them is the frame's own time.</summary>
    public int Count { get; }

    /// <summary>Index of the frame's own time.</summary>
    public int Middle => Count / 2;

    /// <summary>Rows of the detector.</summary>
    public int Height { get; }

    /// <summary>Seconds after the frame's time.</summary>
    /// <param name="index">From 0.</param>
    public double TimeOf(int index) => (index - Middle) * _span / Count;

    /// <summary>Part of a row's exposure for which a sub-exposure stands, 0 to 1.</summary>
    /// <param name="index">Of the sub-exposure, from 0.</param>
    /// <param name="row">From 0 at the top.</param>
    public double WeightOf(int index, int row)
    {
        if (_lineTime == 0.0 || Count == 1)
        {
            return 1.0 / Count;
        }

        double rowMiddle = (row - (0.5 * (Height - 1))) * _lineTime;
        double half = 0.5 * _span / Count;
        double start = Math.Max(rowMiddle - (0.5 * _exposureTime), TimeOf(index) - half);
        double end = Math.Min(rowMiddle + (0.5 * _exposureTime), TimeOf(index) + half);
        return Math.Max(0.0, end - start) / _exposureTime;
    }
}
