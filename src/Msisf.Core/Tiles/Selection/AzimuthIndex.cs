namespace Msisf.Core.Tiles.Selection;

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
