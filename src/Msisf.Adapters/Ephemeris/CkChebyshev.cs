using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>CK type 4: intervals, in each of which Chebyshev series give the quaternion.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 4"; the layout of generic segments is in SPICELIB's sgparam.inc.</remarks>
internal sealed class CkChebyshev : CkSegment
{
    /// <summary>Numbers of a generic segment's last part, which says where the others are; the very last one is their number.</summary>
    private const int MetaWords = 17;

    /// <summary>The numbers of coefficients of seven series, in seven bits each, make one number of a packet.</summary>
    private const int CountBase = 128;

    private const int WordsBeforeSeries = 3;

    private readonly int _packets;
    private readonly int _directory;
    private readonly int _data;
    private readonly int _offset;
    private readonly Lazy<double[]> _starts;

    /// <summary>Reads where the parts of the segment are.</summary>
    /// <exception cref="Core.Errors.BadInputException">They lead out of it.</exception>
    public CkChebyshev(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        Words.Whole(fromEnd: 1, MetaWords, MetaWords);
        int references = Part(6);
        _directory = Part(8);
        _data = Part(11);
        _packets = Words.Whole(MetaWords - 11, min: 1, Words.Count);
        _offset = Part(16);
        int count = Words.Whole(MetaWords - 6, min: 1, Words.Count);
        if (count != _packets)
        {
            throw Words.Damaged($"{_packets} packets have {count} times");
        }

        _starts = new Lazy<double[]>(() => Words.ReadRising(references, count));
    }

    public override IReadOnlyList<TdbInterval> Intervals =>
        [.. Enumerable.Range(0, _packets).Select(Packet).Select(packet => new TdbInterval(packet[0] - packet[1], packet[0] + packet[1]))];

    protected override CkAttitude? Evaluate(double ticks)
    {
        double[] packet = Packet(Math.Max(0, LastAtOrBefore(_starts.Value, ticks)));
        double x = (ticks - packet[0]) / packet[1];
        if (ticks < packet[0] - packet[1] || ticks > packet[0] + packet[1])
        {
            return null;
        }

        Span<double> values = stackalloc double[HasRates ? 7 : 4]; // the quaternion, and the rate
        double counts = packet[2];
        int first = WordsBeforeSeries;
        for (int i = 0; i < values.Length; i++)
        {
            int count = (int)(counts % CountBase);
            counts = Math.Floor(counts / CountBase);
            if (count < 1 || first + count > packet.Length)
            {
                throw Words.Damaged("a series does not fit its packet");
            }

            values[i] = Chebyshev.Evaluate(packet.AsSpan(first, count), x);
            first += count;
        }

        return new CkAttitude(Matrix(values), HasRates ? new Vector3D(values[4], values[5], values[6]) : null);
    }

    /// <summary>Where a part begins, from 0; the part is named by its number in SPICELIB's sgparam.inc.</summary>
    private int Part(int number) => Words.Whole(MetaWords + 1 - number, min: 0, Words.Count);

    private double[] Packet(int index)
    {
        double[] ends = Words.Read(_directory + index, 2);
        if (!(ends[1] - ends[0] - _offset > WordsBeforeSeries && ends[0] >= 1.0 && ends[1] <= Words.Count))
        {
            throw Words.Damaged("a packet has no place");
        }

        double[] packet = Words.Read(_data + (long)ends[0] - 1, (int)(ends[1] - ends[0]) - _offset);
        return packet[1] > 0.0 ? packet : throw Words.Damaged("an interval has no length");
    }
}
