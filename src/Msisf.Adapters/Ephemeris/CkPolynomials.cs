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

    /// <summary>Reads rate, subtype and window, which stand one after another.</summary>
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

    /// <summary>The quaternion at a tick, scalar first, not of length 1.</summary>
    /// <param name="ticks">Within the times.</param>
    /// <param name="times">Ticks of the packets of one interval.</param>
    /// <param name="firstPacket">Where the first of them stands, from 0.</param>
    /// <exception cref="Core.Errors.BadInputException">The kernel is damaged.</exception>
    public double[] At(double ticks, ReadOnlySpan<double> times, long firstPacket)
    {
        int found = times.BinarySearch(ticks);
        int low = Math.Max(0, (found < 0 ? ~found : found) - 1); // as in SPICE, the last one before the tick
        int first = Math.Max(0, low - (Window / 2) + 1);
        int count = Math.Min(times.Length, low + 1 + (Window / 2)) - first;
        double[] packets = Words.Read(firstPacket + ((long)first * Packet), count * Packet);
        Span<double> after = stackalloc double[count];
        for (int i = 0; i < count; i++)
        {
            after[i] = times[first + i] - times[first];
        }

        double time = ticks - times[first];
        return Subtype is 1 or 3 ? Lagrange(packets, after, time) : Hermite(packets, after, time);
    }

    private double[] Lagrange(double[] packets, ReadOnlySpan<double> times, double time)
    {
        Span<double> weights = stackalloc double[times.Length];
        SampleWeights.Lagrange(times, time, weights, stackalloc double[times.Length]);
        double[] q = new double[4];
        double sign = 1.0;
        for (int i = 0; i < times.Length; i++)
        {
            ReadOnlySpan<double> next = packets.AsSpan(i * Packet, 4);
            if (i > 0 && Dot(next, packets.AsSpan((i - 1) * Packet, 4)) < 0.0)
            {
                sign = -sign; // q and -q are one orientation
            }

            for (int k = 0; k < q.Length; k++)
            {
                q[k] += weights[i] * sign * next[k];
            }
        }

        return q;
    }

    private double[] Hermite(double[] packets, ReadOnlySpan<double> times, double time)
    {
        Span<(double Value, double Rate)> ofValues = stackalloc (double, double)[times.Length];
        Span<(double Value, double Rate)> ofRates = stackalloc (double, double)[times.Length];
        SampleWeights.Hermite(times, time, ofValues, ofRates);
        double[] q = new double[4];
        for (int i = 0; i < times.Length; i++)
        {
            ReadOnlySpan<double> next = packets.AsSpan(i * Packet, 8);
            if (i > 0 && Dot(next, packets.AsSpan((i - 1) * Packet, 4)) < 0.0)
            {
                throw Words.Damaged("neighbouring quaternions have opposite signs, between which no polynomial with derivatives leads");
            }

            for (int k = 0; k < q.Length; k++)
            {
                q[k] += (ofValues[i].Value * next[k]) + (ofRates[i].Value * next[k + 4] * SecondsPerTick);
            }
        }

        return q;
    }

    private static double Dot(ReadOnlySpan<double> a, ReadOnlySpan<double> b) =>
        (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]) + (a[3] * b[3]);
}
