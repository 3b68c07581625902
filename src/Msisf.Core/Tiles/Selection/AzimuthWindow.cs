namespace Msisf.Core.Tiles.Selection;

/// <summary>A range of azimuths, cut into bins of equal width.</summary>
internal sealed class AzimuthWindow
{
    private readonly double _middle;
    private readonly double _width;

    /// <param name="middle">Middle of the range, rad.</param>
    /// <param name="width">Width of the range, rad; 2 pi or more is the whole circle.</param>
    /// <param name="maxBinWidth">Maximum width of a bin, rad; wider bins are made only to keep to <paramref name="mostBins"/>.</param>
    /// <param name="mostBins">Maximum number of bins.</param>
    public AzimuthWindow(double middle, double width, double maxBinWidth, int mostBins)
    {
        IsFull = width >= 2.0 * Math.PI;
        _middle = middle;
        _width = Math.Min(width, 2.0 * Math.PI);
        Bins = Math.Clamp((int)Math.Ceiling(_width / maxBinWidth), Math.Min(16, mostBins), mostBins);
        BinWidth = _width / Bins;
    }

    /// <summary>Whether the window is the whole circle.</summary>
    public bool IsFull { get; }

    /// <summary>Number of bins.</summary>
    public int Bins { get; }

    /// <summary>Width of a bin, rad.</summary>
    public double BinWidth { get; }

    /// <summary>The same angle in [-pi, pi].</summary>
    public static double Wrapped(double angle)
    {
        // Math.IEEERemainder is exact but ten times slower, and is not needed: differences of azimuths are within a few turns.
        return angle - (2.0 * Math.PI * Math.Round(angle / (2.0 * Math.PI)));
    }

    /// <summary>Azimuth of a bin's lower border, rad.</summary>
    public double Border(int bin) => _middle - (0.5 * _width) + (bin * BinWidth);

    /// <summary>
    /// Position of an azimuth, in bins from the window's lower border; if the window is not the whole circle, it may be below 0 or above
    /// <see cref="Bins"/>.
    /// </summary>
    public double Place(double azimuth) => (FromMiddle(azimuth) + (0.5 * _width)) / BinWidth;

    /// <summary>The bins that a range of azimuths touches within the window.</summary>
    /// <param name="azimuth">rad, of the range's middle.</param>
    /// <param name="halfWidth">rad.</param>
    /// <returns>
    /// First bin, which may be negative if the window is the whole circle, and the number of bins; 0 if the range is outside.
    /// </returns>
    public (int First, int Count) Touched(double azimuth, double halfWidth)
    {
        double fromMiddle = FromMiddle(azimuth);
        bool comesBack = Math.Abs(fromMiddle) + halfWidth >= (2.0 * Math.PI) - (0.5 * _width);
        if (halfWidth >= Math.PI || (!IsFull && comesBack))
        {
            return (0, Bins);
        }

        int first = (int)Math.Floor((fromMiddle - halfWidth + (0.5 * _width)) / BinWidth);
        int last = (int)Math.Floor((fromMiddle + halfWidth + (0.5 * _width)) / BinWidth);
        if (IsFull)
        {
            return (first, Math.Min(last - first + 1, Bins));
        }

        first = Math.Max(first, 0);
        last = Math.Min(last, Bins - 1);
        return (first, Math.Max(0, last - first + 1));
    }

    private double FromMiddle(double azimuth) => Wrapped(azimuth - _middle);
}
