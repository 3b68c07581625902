using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The polynomials of CK types 5 and 6, of any of their subtypes.</summary>
/// <param name="Words">The segment.</param>
/// <param name="Subtype">0 and 2: Hermite, with derivatives; 1 and 3: Lagrange. 2 and 3 have angular velocities.</param>
/// <param name="Window">Through how many quaternions a polynomial goes.</param>
/// <param name="SecondsPerTick">Nominal rate of the clock; derivatives are per second.</param>
internal sealed record CkPolynomials(DafWords Words, int Subtype, int Window, double SecondsPerTick)
{
    private const int MaximumWindow = 32;

    private static readonly int[] PacketWords = [8, 4, 14, 7];

    public int Packet => PacketWords[Subtype];

    /// <summary>Reads rate, subtype and window, which are one after another.</summary>
    /// <param name="words">The segment.</param>
    /// <param name="end">Behind them, from 0.</param>
    /// <exception cref="Core.Errors.BadInputException">They are out of range.</exception>
    public static CkPolynomials Read(DafWords words, long end)
    {
        double rate = words.Read(end - 3, 1)[0];
        int fromEnd = (int)Math.Min(words.Count - end, int.MaxValue - 2);
        CkPolynomials read = new(
            words, words.Whole(fromEnd + 2, min: 0, PacketWords.Length - 1), words.Whole(fromEnd + 1, min: 2, MaximumWindow), rate);
        return rate > 0.0 ? read : throw words.Damaged("its clock has no rate");
    }

    /// <summary>The numbers of a packet at a tick: the quaternion, scalar first and not of length 1, and the rate.</summary>
    /// <param name="ticks">Within the times.</param>
    /// <param name="times">Ticks of the packets of one interval.</param>
    /// <param name="firstPacket">Where the first of them is, from 0.</param>
    /// <param name="followsOthers">
    /// Whether other packets lie before the interval: at its first tick CSPICE then counts the last of those as the one before the tick.
    /// </param>
    /// <exception cref="Core.Errors.BadInputException">The kernel is damaged.</exception>
    public (double[] Quaternion, Vector3D Rate) At(double ticks, ReadOnlySpan<double> times, long firstPacket, bool followsOthers)
    {
        int found = times.BinarySearch(ticks);
        int low = Math.Max(followsOthers ? -1 : 0, (found < 0 ? ~found : found) - 1); // as in SPICE, the last one before the tick
        int first = Math.Max(0, low - (Window / 2) + 1);
        int count = Math.Min(times.Length, low + 1 + (Window / 2)) - first;
        double[] packets = Words.Read(firstPacket + ((long)first * Packet), count * Packet);
        Span<double> after = stackalloc double[count];
        for (int i = 0; i < count; i++)
        {
            after[i] = (times[first + i] - times[first]) * SecondsPerTick;
        }

        double seconds = (ticks - times[first]) * SecondsPerTick;
        double[] q = new double[4];
        double[] rates = new double[4];
        Span<(double Value, double Rate)> ofValues = stackalloc (double, double)[count];
        Span<(double Value, double Rate)> ofRates = stackalloc (double, double)[count];
        bool isHermite = Subtype is 0 or 2;
        if (isHermite)
        {
            SampleWeights.Hermite(after, seconds, ofValues, ofRates);
            Add(packets, 4, ofValues, ofRates, q, rates, areSignsFree: false);
        }
        else
        {
            Span<double> values = stackalloc double[count];
            Span<double> derivatives = stackalloc double[count];
            SampleWeights.Lagrange(after, seconds, values, derivatives);
            for (int i = 0; i < count; i++)
            {
                ofValues[i] = (values[i], derivatives[i]);
            }

            Add(packets, 0, ofValues, ofRates, q, rates, areSignsFree: true);
        }

        return (q, Subtype < 2 ? OfDerivative(q, rates) : Stated(packets, isHermite, ofValues, ofRates));
    }

    /// <summary>The angular velocity that a packet states, with a polynomial of its own.</summary>
    private Vector3D Stated(
        double[] packets, bool isHermite, ReadOnlySpan<(double Value, double Rate)> ofValues,
        ReadOnlySpan<(double Value, double Rate)> ofRates)
    {
        int offset = isHermite ? 8 : 4;
        Vector3D rate = default;
        for (int i = 0; i < ofValues.Length; i++)
        {
            ReadOnlySpan<double> packet = packets.AsSpan((i * Packet) + offset);
            rate += ofValues[i].Value * new Vector3D(packet[0], packet[1], packet[2]);
            rate += isHermite ? ofRates[i].Value * new Vector3D(packet[3], packet[4], packet[5]) : default;
        }

        return rate;
    }

    /// <summary>rad/s about the reference frame's axes: the C-matrix of the quaternion turns against the instrument.</summary>
    private static Vector3D OfDerivative(double[] q, double[] dq)
    {
        (Vector3D v, Vector3D dv) = (new Vector3D(q[1], q[2], q[3]), new Vector3D(dq[1], dq[2], dq[3]));
        double square = v.LengthSquared + (q[0] * q[0]);
        return -2.0 / square * ((q[0] * dv) - (dq[0] * v) - Vector3D.Cross(v, dv));
    }

    /// <summary>Sums up quaternions and their derivatives.</summary>
    /// <param name="offset">Where the derivatives are in a packet; 0 for none.</param>
    /// <param name="areSignsFree">Whether q and -q may be side by side.</param>
    private void Add(
        double[] packets, int offset, ReadOnlySpan<(double Value, double Rate)> ofValues,
        ReadOnlySpan<(double Value, double Rate)> ofRates, double[] q, double[] rates, bool areSignsFree)
    {
        double sign = 1.0;
        for (int i = 0; i < ofValues.Length; i++)
        {
            ReadOnlySpan<double> next = packets.AsSpan(i * Packet, offset + 4);
            if (i > 0 && Dot(next, packets.AsSpan((i - 1) * Packet, 4)) < 0.0)
            {
                sign = areSignsFree
                    ? -sign
                    : throw Words.Damaged(
                        "neighbouring quaternions have opposite signs, between which no polynomial with derivatives leads");
            }

            for (int k = 0; k < q.Length; k++)
            {
                double derivative = offset == 0 ? 0.0 : next[offset + k];
                q[k] += sign * ((ofValues[i].Value * next[k]) + (ofRates[i].Value * derivative));
                rates[k] += sign * ((ofValues[i].Rate * next[k]) + (ofRates[i].Rate * derivative));
            }
        }
    }

    private static double Dot(ReadOnlySpan<double> a, ReadOnlySpan<double> b) =>
        (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]) + (a[3] * b[3]);
}

/// <summary>CK type 5, ESOC's: quaternions with polynomials through those nearest to a time; intervals tell where there are gaps.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 5".</remarks>
internal sealed class CkInterpolated : CkSegment
{
    private readonly CkPolynomials _polynomials;
    private readonly Lazy<TickIntervals> _times;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkInterpolated(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        _polynomials = CkPolynomials.Read(Words, Words.Count - 2);
        int record = _polynomials.Packet;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (record + 1));
        int intervals = Words.Whole(fromEnd: 2, min: 1, count);
        _times = new Lazy<TickIntervals>(() => TickIntervals.Read(Words, record, count, intervals));
    }

    public override IReadOnlyList<TdbInterval> Intervals => _times.Value.All;

    protected override CkAttitude? Evaluate(double ticks)
    {
        TickIntervals times = _times.Value;
        (int first, int end) = times.Of(ticks);
        return ticks >= times.Ticks[first] && ticks <= times.Ticks[end - 1]
            ? Attitude(_polynomials.At(
                ticks, times.Ticks.AsSpan(first, end - first), (long)first * _polynomials.Packet, followsOthers: first > 0))
            : null;
    }
}

/// <summary>CK type 6, ESOC's: pieces one after another, each with quaternions and polynomials of its own kind.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 6".</remarks>
internal sealed class CkPieces : CkSegment
{
    private readonly bool _isLaterAtBorder;
    private readonly Lazy<(double[] Bounds, Piece[] Pieces)> _pieces;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkPieces(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count);
        _isLaterAtBorder = Words.Whole(fromEnd: 2, min: -1, max: 1) == 1;
        _pieces = new Lazy<(double[], Piece[])>(() => ReadPieces(count));
    }

    public override IReadOnlyList<TdbInterval> Intervals =>
    [
        .. _pieces.Value.Pieces.Select((piece, i) => new TdbInterval(
            _pieces.Value.Bounds[i],
            Math.Max(_pieces.Value.Bounds[i], Math.Min(_pieces.Value.Bounds[i + 1], piece.Ticks[^1])))),
    ];

    protected override CkAttitude? Evaluate(double ticks)
    {
        (double[] bounds, Piece[] pieces) = _pieces.Value;
        int index = LastAtOrBefore(bounds, ticks);
        if (index >= 0 && index < bounds.Length && bounds[index] == ticks && !_isLaterAtBorder)
        {
            index--;
        }

        Piece piece = pieces[Math.Clamp(index, 0, pieces.Length - 1)];
        return ticks >= piece.Ticks[0] && ticks <= piece.Ticks[^1]
            ? Attitude(piece.Polynomials.At(ticks, piece.Ticks, piece.First, followsOthers: false))
            : null;
    }

    private (double[] Bounds, Piece[] Pieces) ReadPieces(int count)
    {
        // At the end: bounds of the pieces, their directory, where the pieces begin, and two numbers.
        double[] begins = Words.Read(Words.Count - 3 - count, count + 1);
        double[] bounds = Words.ReadRising(Words.Count - 4 - (2L * count) - (count / 100), count + 1);
        Piece[] pieces = new Piece[count];
        for (int i = 0; i < count; i++)
        {
            if (!(begins[i] >= 1.0 && begins[i + 1] > begins[i] + 4.0 && begins[i + 1] <= Words.Count))
            {
                throw Words.Damaged("a piece has no place");
            }

            (long first, long end) = ((long)begins[i] - 1, (long)begins[i + 1] - 1);
            CkPolynomials polynomials = CkPolynomials.Read(Words, end - 1);
            int packets = Words.Whole((int)(Words.Count - end) + 1, min: 1, (end - first) / (polynomials.Packet + 1));
            pieces[i] = new Piece(polynomials, first, Words.ReadRising(first + ((long)packets * polynomials.Packet), packets));
        }

        return (bounds, pieces);
    }

    private sealed record Piece(CkPolynomials Polynomials, long First, double[] Ticks);
}
