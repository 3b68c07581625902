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

/// <summary>Finds members in the same directions: each member is listed in all bins of azimuth that its bounds touch.</summary>
/// <typeparam name="T">Type of the members.</typeparam>
internal sealed class AzimuthIndex<T>
{
    private readonly AzimuthWindow _window;
    private readonly List<T>[] _members;

    /// <param name="bins">Number of bins of the whole circle.</param>
    public AzimuthIndex(int bins)
    {
        _window = new AzimuthWindow(0.0, 2.0 * Math.PI, 2.0 * Math.PI / bins, bins);
        _members = new List<T>[bins];
        for (int bin = 0; bin < bins; bin++)
        {
            _members[bin] = [];
        }
    }

    /// <summary>Adds a member to all bins of its bounds.</summary>
    public void Add(T member, in PolarBounds bounds)
    {
        foreach (int bin in Bins(bounds))
        {
            _members[bin].Add(member);
        }
    }

    /// <summary>Removes all members.</summary>
    public void Clear()
    {
        foreach (List<T> members in _members)
        {
            members.Clear();
        }
    }

    /// <summary>Members of a bin, in the order in which they were added.</summary>
    public List<T> this[int bin] => _members[bin];

    /// <summary>The bins that bounds touch.</summary>
    public BinRange Bins(in PolarBounds bounds)
    {
        (int first, int count) = _window.Touched(bounds.Azimuth, bounds.HalfWidth);
        return new BinRange(first, count, _members.Length);
    }

    /// <summary>Neighbouring bins on the circle.</summary>
    public struct BinRange
    {
        private readonly int _bins;
        private int _left;

        public BinRange(int first, int count, int bins)
        {
            _bins = bins;
            _left = count;
            Current = ((first - 1) % bins + bins) % bins;
        }

        public int Current { get; private set; }

        public readonly BinRange GetEnumerator() => this;

        public bool MoveNext()
        {
            Current = Current + 1 == _bins ? 0 : Current + 1;
            return _left-- > 0;
        }
    }
}
