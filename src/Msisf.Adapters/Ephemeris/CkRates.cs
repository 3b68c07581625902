using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>CK type 2: intervals, in each of which an orientation turns at a constant rate.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 2".</remarks>
internal sealed class CkRates : CkSegment
{
    private const int RecordWords = 8;

    private readonly Lazy<(double[] Starts, double[] Ends)> _times;

    /// <summary>Takes the number of intervals from the segment's size, which alone tells it.</summary>
    /// <exception cref="Core.Errors.BadInputException">It is too small.</exception>
    public CkRates(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        // Each interval has a record, a start and an end; each hundred starts that are followed by another have an entry in a directory.
        int count = (int)Math.Min((((Words.Count * 100) - 1) / 1001) + 1, int.MaxValue / 16);
        if (((long)count * (RecordWords + 2)) + ((count - 1) / 100) != Words.Count)
        {
            throw Words.Damaged("no number of intervals fits its size");
        }

        _times = new Lazy<(double[], double[])>(() => (
            Words.ReadRising((long)count * RecordWords, count), Words.ReadRising((long)count * (RecordWords + 1), count)));
    }

    public override IReadOnlyList<TdbInterval> Intervals =>
        [.. _times.Value.Starts.Zip(_times.Value.Ends, (start, end) => new TdbInterval(start, Math.Max(start, end)))];

    protected override RotationMatrix? Evaluate(double ticks)
    {
        int index = LastAtOrBefore(_times.Value.Starts, ticks);
        if (index < 0 || ticks > _times.Value.Ends[index])
        {
            return null;
        }

        double[] record = Words.Read((long)index * RecordWords, RecordWords);
        RotationMatrix start = Matrix(record);
        Vector3D rate = new(record[4], record[5], record[6]);
        double angle = (ticks - _times.Value.Starts[index]) * record[7] * rate.Length;
        return rate.Length == 0.0 ? start : start * Turn(rate, angle).Transposed;
    }

    /// <summary>The rotation of vectors by an angle about an axis.</summary>
    internal static RotationMatrix Turn(Vector3D axis, double angle)
    {
        UnitQuaternion turn = UnitQuaternion.FromAxisAngle(axis, angle);
        return new RotationMatrix(turn * Vector3D.UnitX, turn * Vector3D.UnitY, turn * Vector3D.UnitZ).Transposed;
    }
}
