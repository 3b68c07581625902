using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// A binary kernel (double precision array file), little- or big-endian. Opening reads the file record and the summaries;
/// data are read when asked for. Safe for several threads.
/// </summary>
/// <remarks>NAIF, DAF Required Reading.</remarks>
public sealed class DafFile : IDisposable
{
    private const int RecordBytes = 1024;
    private const int WordBytes = sizeof(double);
    private const int WordsBeforeSummaries = 3;

    /// <summary>Doubles of a summary: the segment's first and last time, of a CK in ticks.</summary>
    private const int SummaryDoubles = 2;

    /// <summary>Bytes in a file record that a transfer as text changes; kernels before 1999 have none.</summary>
    private static readonly byte[] TransferMark = [.. "FTPSTR:\r:\n:\r\n:\r\0:"u8, 0x81, (byte)':', 0x10, 0xCE, .. ":ENDFTP"u8];

    private readonly Stream _stream;
    private readonly Lock _streamLock = new();
    private readonly bool _isLittleEndian;

    /// <summary>Opens a kernel. The stream is disposed with the object.</summary>
    /// <param name="stream">Must be able to seek.</param>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">Not an SPK, binary PCK or CK, damaged or cut short.</exception>
    public DafFile(Stream stream, string fileName)
    {
        _stream = stream;
        FileName = fileName;
        Span<byte> fileRecord = stackalloc byte[RecordBytes];
        if (stream.Length < RecordBytes)
        {
            throw new BadInputException(
                $"{fileName}: {stream.Length} bytes are too few for a binary kernel ({RecordBytes} at least). Get the file anew.");
        }

        ReadBytes(0, fileRecord);
        IdWord = Encoding.ASCII.GetString(fileRecord[..8]).TrimEnd();
        int summaryIntegers = IdWord switch
        {
            "DAF/SPK" or "DAF/CK" => 6,
            "DAF/PCK" => 5,
            _ => throw new BadInputException($"{fileName}: the file begins with \"{IdWord}\"; DAF/SPK, DAF/PCK or DAF/CK expected."),
        };
        string format = Encoding.ASCII.GetString(fileRecord.Slice(88, 8));
        _isLittleEndian = format switch
        {
            "LTL-IEEE" => true,
            "BIG-IEEE" => false,
            _ => throw new BadInputException(
                $"{fileName}: the number format is \"{format.Trim()}\"; LTL-IEEE or BIG-IEEE expected. "
                    + $"Convert the kernel with NAIF's bingo."),
        };
        int doubles = ReadInt32(fileRecord[8..]);
        int integers = ReadInt32(fileRecord[12..]);
        if (doubles != SummaryDoubles || integers != summaryIntegers)
        {
            throw Damaged($"summaries of {doubles} doubles and {integers} integers, {SummaryDoubles} and {summaryIntegers} expected");
        }

        int mark = fileRecord.IndexOf(TransferMark.AsSpan(0, "FTPSTR".Length));
        if (mark >= 0 && !fileRecord[mark..].StartsWith(TransferMark))
        {
            throw new BadInputException(
                $"{fileName}: damaged kernel: it was transferred as text, which changes line ends. Get the file anew, as binary.");
        }

        Summaries = ReadSummaries(ReadInt32(fileRecord[76..]), summaryIntegers);
    }

    /// <summary>The file's name, for messages.</summary>
    public string FileName { get; }

    /// <summary>Whether the bytes of its numbers begin with the lowest.</summary>
    public bool IsLittleEndian => _isLittleEndian;

    /// <summary>"DAF/SPK", "DAF/PCK" or "DAF/CK".</summary>
    public string IdWord { get; }

    /// <summary>The segments in the order of the file.</summary>
    public IReadOnlyList<DafSummary> Summaries { get; }

    /// <summary>Opens a kernel by its path.</summary>
    /// <exception cref="BadInputException">It can't be opened, is none of these kernels, damaged or cut short.</exception>
    public static DafFile Open(string path)
    {
        FileStream stream = KernelFile.OpenBinary(path);
        try
        {
            return new DafFile(stream, path);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    /// <summary>Reads consecutive doubles.</summary>
    /// <param name="firstAddress">Address of the first one, from 1.</param>
    /// <param name="values">Receives them.</param>
    /// <exception cref="ExternalPartException">The file can't be read.</exception>
    public void ReadDoubles(long firstAddress, Span<double> values)
    {
        Span<byte> bytes = MemoryMarshal.AsBytes(values);
        ReadBytes((firstAddress - 1) * WordBytes, bytes);
        if (_isLittleEndian != BitConverter.IsLittleEndian)
        {
            Span<long> words = MemoryMarshal.Cast<byte, long>(bytes);
            BinaryPrimitives.ReverseEndianness(words, words);
        }
    }

    /// <summary>The error for a file that contradicts itself.</summary>
    /// <param name="what">What was found.</param>
    public BadInputException Damaged(string what) => new($"{FileName}: damaged kernel: {what}. Get the file anew.");

    /// <inheritdoc/>
    public void Dispose() => _stream.Dispose();

    private List<DafSummary> ReadSummaries(int firstRecord, int integers)
    {
        int summaryBytes = WordBytes * (SummaryDoubles + ((integers + 1) / 2));
        int maximumPerRecord = (RecordBytes - (WordsBeforeSummaries * WordBytes)) / summaryBytes;
        long recordsLeft = _stream.Length / RecordBytes;
        List<DafSummary> summaries = [];
        Span<byte> record = stackalloc byte[RecordBytes];
        double next = firstRecord;
        while (next != 0.0)
        {
            if (!(next >= 1.0 && next * RecordBytes <= _stream.Length) || recordsLeft-- == 0)
            {
                throw Damaged("the chain of its summary records leads out of the file or in a ring");
            }

            ReadBytes(((long)next - 1) * RecordBytes, record);
            double count = ReadDouble(record[(2 * WordBytes)..]);
            if (!(count >= 0.0 && count <= maximumPerRecord))
            {
                throw Damaged("a summary record with an impossible number of segments");
            }

            for (int i = 0; i < (int)count; i++)
            {
                summaries.Add(ReadSummary(record.Slice((WordsBeforeSummaries * WordBytes) + (i * summaryBytes), summaryBytes), integers));
            }

            next = ReadDouble(record);
        }

        return summaries;
    }

    private DafSummary ReadSummary(ReadOnlySpan<byte> bytes, int integers)
    {
        TdbInterval interval = new(ReadDouble(bytes), ReadDouble(bytes[WordBytes..]));
        int[] values = new int[integers];
        for (int i = 0; i < integers; i++)
        {
            values[i] = ReadInt32(bytes[((SummaryDoubles * WordBytes) + (i * sizeof(int)))..]);
        }

        DafSummary summary = new(interval, values);
        if (!(double.IsFinite(interval.Start) && double.IsFinite(interval.End) && interval.Start <= interval.End))
        {
            throw Damaged("a segment whose times do not rise");
        }

        if (summary.FirstAddress < 1 || summary.LastAddress < summary.FirstAddress)
        {
            throw Damaged("a segment with impossible addresses");
        }

        return (long)summary.LastAddress * WordBytes <= _stream.Length
            ? summary
            : throw Damaged($"it has {_stream.Length} bytes, but its data need {(long)summary.LastAddress * WordBytes}: it is cut short");
    }

    private double ReadDouble(ReadOnlySpan<byte> bytes) =>
        _isLittleEndian ? BinaryPrimitives.ReadDoubleLittleEndian(bytes) : BinaryPrimitives.ReadDoubleBigEndian(bytes);

    private int ReadInt32(ReadOnlySpan<byte> bytes) =>
        _isLittleEndian ? BinaryPrimitives.ReadInt32LittleEndian(bytes) : BinaryPrimitives.ReadInt32BigEndian(bytes);

    private void ReadBytes(long offset, Span<byte> bytes)
    {
        try
        {
            lock (_streamLock)
            {
                _stream.Seek(offset, SeekOrigin.Begin);
                _stream.ReadExactly(bytes);
            }
        }
        catch (IOException exception)
        {
            throw new ExternalPartException($"{FileName}: can't be read: {exception.Message}", exception);
        }
    }
}
