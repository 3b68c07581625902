using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// A segment of SPK type 2 or 3, or of PCK type 2: records of equal length, each with three Chebyshev series; SPK type 3 adds three series
/// for the velocities. A record is read when it is first needed, and kept.
/// </summary>
/// <remarks>NAIF, SPK Required Reading, "Type 2" and "Type 3"; PCK Required Reading, "Type 2".</remarks>
internal sealed class ChebyshevSegment : IEphemerisSegment
{
    /// <summary>Doubles at the end of a segment: INIT, INTLEN, RSIZE, N.</summary>
    private const int DirectoryWords = 4;

    /// <summary>Doubles at the start of a record: its middle and its half length.</summary>
    private const int WordsBeforeSeries = 2;

    /// <summary>Series in a record that has some for the rates, too.</summary>
    private const int SeriesWithRates = 6;

    private readonly DafFile _file;
    private readonly int _firstAddress;
    private readonly double _start;
    private readonly double _recordSeconds;
    private readonly int _recordWords;
    private readonly int _coefficients;
    private readonly bool _hasRates;
    private readonly double[]?[] _records;

    /// <summary>Reads the segment's directory.</summary>
    /// <param name="file">The kernel; must outlive the segment.</param>
    /// <param name="body">NAIF's number.</param>
    /// <param name="center">NAIF's number.</param>
    /// <param name="seriesPerRecord">3, or 6 with the velocities of SPK type 3.</param>
    /// <exception cref="BadInputException">The directory contradicts the segment's size.</exception>
    public ChebyshevSegment(DafFile file, DafSummary summary, int body, int center, int seriesPerRecord)
    {
        _file = file;
        Body = body;
        Center = center;
        Interval = summary.Interval;
        _firstAddress = summary.FirstAddress;

        Span<double> directory = stackalloc double[DirectoryWords];
        long words = (long)summary.LastAddress - summary.FirstAddress + 1;
        if (words < DirectoryWords)
        {
            throw file.Damaged($"the segment of body {body} is too short");
        }

        file.ReadDoubles(summary.LastAddress - DirectoryWords + 1, directory);
        _start = directory[0];
        _recordSeconds = directory[1];
        double size = directory[2];
        double count = directory[3];
        bool isSound = double.IsFinite(_start)
            && double.IsFinite(_recordSeconds) && _recordSeconds > 0.0
            && size >= WordsBeforeSeries + seriesPerRecord && (size - WordsBeforeSeries) % seriesPerRecord == 0.0
            && count >= 1.0
            && (size * count) + DirectoryWords == words;
        if (!isSound)
        {
            throw file.Damaged($"the directory of the segment of body {body} does not fit its size");
        }

        _recordWords = (int)size;
        _coefficients = (_recordWords - WordsBeforeSeries) / seriesPerRecord;
        _hasRates = seriesPerRecord == SeriesWithRates;
        _records = new double[(int)count][];
    }

    public int Body { get; }

    public int Center { get; }

    public TdbInterval Interval { get; }

    public Vector3D ValueAt(TdbTime tdb)
    {
        ReadOnlySpan<double> record = RecordAt(tdb);
        double x = (tdb - record[0]) / record[1];
        return new Vector3D(
            Chebyshev.Evaluate(Series(record, 0), x),
            Chebyshev.Evaluate(Series(record, 1), x),
            Chebyshev.Evaluate(Series(record, 2), x));
    }

    public Vector3D RateAt(TdbTime tdb)
    {
        ReadOnlySpan<double> record = RecordAt(tdb);
        double x = (tdb - record[0]) / record[1];
        return _hasRates
            ? new Vector3D(
                Chebyshev.Evaluate(Series(record, 3), x),
                Chebyshev.Evaluate(Series(record, 4), x),
                Chebyshev.Evaluate(Series(record, 5), x))
            : new Vector3D(
                Chebyshev.Derivative(Series(record, 0), x),
                Chebyshev.Derivative(Series(record, 1), x),
                Chebyshev.Derivative(Series(record, 2), x)) / record[1];
    }

    private ReadOnlySpan<double> RecordAt(TdbTime tdb)
    {
        // As in SPICE the last record also serves the segment's very end.
        int index = (int)Math.Clamp((tdb - _start) / _recordSeconds, 0.0, _records.Length - 1.0);
        return Volatile.Read(ref _records[index]) ?? ReadRecord(index);
    }

    private ReadOnlySpan<double> Series(ReadOnlySpan<double> record, int index) =>
        record.Slice(WordsBeforeSeries + (index * _coefficients), _coefficients);

    /// <summary>Two threads may read the same record at once; both get the same numbers, and one copy stays.</summary>
    private double[] ReadRecord(int index)
    {
        double[] record = new double[_recordWords];
        _file.ReadDoubles(_firstAddress + ((long)index * _recordWords), record);
        foreach (double value in record)
        {
            if (!double.IsFinite(value))
            {
                throw _file.Damaged($"record {index + 1} of body {Body} holds a number that is not finite");
            }
        }

        if (record[1] <= 0.0)
        {
            throw _file.Damaged($"record {index + 1} of body {Body} has no length");
        }

        Volatile.Write(ref _records[index], record);
        return record;
    }
}
