namespace Msisf.Core.Tiles.Selection;

/// <summary>Tiles or blocks by the azimuths that they cover, so that a search meets only those beside it.</summary>
internal sealed class AzimuthIndex
{
    private readonly AzimuthWindow _window;
    private readonly List<int>[] _members;

    /// <param name="bins">All around.</param>
    public AzimuthIndex(int bins)
    {
        _window = new AzimuthWindow(0.0, 2.0 * Math.PI, 2.0 * Math.PI / bins, bins);
        _members = new List<int>[bins];
        for (int bin = 0; bin < bins; bin++)
        {
            _members[bin] = [];
        }
    }

    /// <summary>Adds a number under all azimuths of its bounds.</summary>
    public void Add(int member, in PolarBounds bounds)
    {
        foreach (int bin in Bins(bounds))
        {
            _members[bin].Add(member);
        }
    }

    /// <summary>Removes all members.</summary>
    public void Clear()
    {
        foreach (List<int> members in _members)
        {
            members.Clear();
        }
    }

    /// <summary>Members of a bin, in the order in which they were added.</summary>
    public List<int> this[int bin] => _members[bin];

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
