using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Segments of loaded kernels. Where several cover the same body and time, the one loaded last is used, as in SPICE.</summary>
public sealed class SegmentTable
{
    /// <summary>NAIF's number of the solar system's barycentre, at which every chain of centres ends.</summary>
    public const int SolarSystemBarycenter = 0;

    private readonly Dictionary<int, List<IEphemerisSegment>> _inLoadOrder = [];

    /// <summary>Sorts segments by body.</summary>
    /// <param name="segmentsInLoadOrder">In the order of loading; within a kernel, in the order of the file.</param>
    public SegmentTable(IEnumerable<IEphemerisSegment> segmentsInLoadOrder)
    {
        foreach (IEphemerisSegment segment in segmentsInLoadOrder)
        {
            if (!_inLoadOrder.TryGetValue(segment.Body, out List<IEphemerisSegment>? segments))
            {
                segments = [];
                _inLoadOrder.Add(segment.Body, segments);
            }

            segments.Add(segment);
        }
    }

    /// <summary>The segment to use, or null if no kernel covers that body at that time.</summary>
    /// <param name="body">NAIF's number.</param>
    public IEphemerisSegment? Find(int body, TdbTime time)
    {
        if (_inLoadOrder.TryGetValue(body, out List<IEphemerisSegment>? segments))
        {
            for (int i = segments.Count - 1; i >= 0; i--)
            {
                if (segments[i].Interval.Contains(time))
                {
                    return segments[i];
                }
            }
        }

        return null;
    }

    /// <summary>The times for which the body has data of its own.</summary>
    /// <param name="body">NAIF's number.</param>
    public TdbCover CoverOf(int body) => TdbCover.Union(SegmentsOf(body).Select(segment => segment.Interval));

    /// <summary>The times for which the body's position is known up to the solar system's barycentre.</summary>
    /// <param name="body">NAIF's number.</param>
    public TdbCover CoverOfChain(int body) => CoverOfChain(body, []);

    private TdbCover CoverOfChain(int body, HashSet<int> bodiesOnTheWay)
    {
        if (body == SolarSystemBarycenter)
        {
            return TdbCover.Everything;
        }

        if (!bodiesOnTheWay.Add(body))
        {
            return TdbCover.Empty;
        }

        TdbCover cover = TdbCover.Union(
            from byCenter in SegmentsOf(body).GroupBy(segment => segment.Center)
            let own = TdbCover.Union(byCenter.Select(segment => segment.Interval))
            from interval in own.Intersect(CoverOfChain(byCenter.Key, bodiesOnTheWay)).Intervals
            select interval);
        bodiesOnTheWay.Remove(body);
        return cover;
    }

    private List<IEphemerisSegment> SegmentsOf(int body) =>
        _inLoadOrder.TryGetValue(body, out List<IEphemerisSegment>? segments) ? segments : [];
}
