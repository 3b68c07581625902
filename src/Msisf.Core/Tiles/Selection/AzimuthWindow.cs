namespace Msisf.Core.Tiles.Selection;

/// <summary>A range of azimuths, cut into bins of equal width.</summary>
internal sealed class AzimuthWindow
{
    private readonly double _middle;
    private readonly double _width;

    /// <param name="middle">rad.</param>
    /// <param name="width">rad; 2 pi or more: all around.</param>
    /// <param name="maxBinWidth">rad.</param>
    /// <param name="mostBins">At most so many bins are made.</param>
    public AzimuthWindow(double middle, double width, double maxBinWidth, int mostBins)
    {
        IsFull = width >= 2.0 * Math.PI;
        _middle = middle;
        _width = Math.Min(width, 2.0 * Math.PI);
        Bins = Math.Clamp((int)Math.Ceiling(_width / maxBinWidth), Math.Min(16, mostBins), mostBins);
        BinWidth = _width / Bins;
    }

    /// <summary>All around.</summary>
    public bool IsFull { get; }

    /// <summary>Number of bins.</summary>
    public int Bins { get; }

    /// <summary>rad.</summary>
    public double BinWidth { get; }

    /// <summary>The same angle in [-pi, pi].</summary>
    public static double Wrapped(double angle)
    {
        // Math.IEEERemainder is exact and ten times slower; differences of azimuths are within a few turns.
        return angle - (2.0 * Math.PI * Math.Round(angle / (2.0 * Math.PI)));
    }

    /// <summary>Azimuth of a bin's lower border, rad.</summary>
    public double Border(int bin) => _middle - (0.5 * _width) + (bin * BinWidth);

    /// <summary>
    /// Where an azimuth lies, in bins from the window's lower border; outside a window that is not full it may be below 0 or above
    /// <see cref="Bins"/>.
    /// </summary>
    public double Place(double azimuth) => (FromMiddle(azimuth) + (0.5 * _width)) / BinWidth;

    /// <summary>The bins that a range of azimuths touches within the window.</summary>
    /// <param name="azimuth">rad, of the range's middle.</param>
    /// <param name="halfWidth">rad.</param>
    /// <returns>First bin, perhaps negative (a full window goes round), and how many; 0 if the range is outside.</returns>
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
