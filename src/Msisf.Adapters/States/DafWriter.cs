using System.Buffers.Binary;
using System.Text;

namespace Msisf.Adapters.States;

/// <summary>Writes a binary kernel (double precision array file), little-endian.</summary>
/// <remarks>NAIF, DAF Required Reading.</remarks>
internal static class DafWriter
{
    private const int RecordBytes = 1024;
    private const int RecordWords = RecordBytes / sizeof(double);
    private const int CommentBytes = 1000; // of a record
    private const int Integers = 6;
    private const int SummaryBytes = 40; // two doubles and six integers; a name has as many

    /// <summary>Name of file and segment; the standard allows 40 characters.</summary>
    private const string Name = "msis states";

    /// <summary>What NAIF's programs look for to find damage by transfers of text.</summary>
    private static readonly byte[] TransferMark =
        [.. "FTPSTR:\r:\n:\r\n:\r\0:"u8, 0x81, .. ":"u8, 0x10, 0xCE, .. ":ENDFTP"u8];

    /// <summary>Writes the file.</summary>
    /// <param name="stream">Gets it.</param>
    /// <param name="idWord">"DAF/SPK" or "DAF/CK".</param>
    /// <param name="comments">Lines of the comment area, ASCII.</param>
    /// <param name="segments">At most 25, which one record of summaries holds.</param>
    public static void Write(Stream stream, string idWord, IReadOnlyList<string> comments, IReadOnlyList<DafSegment> segments)
    {
        byte[] comment = Encoding.ASCII.GetBytes(string.Join('\0', comments) + "\0\u0004");
        int commentRecords = (comment.Length + CommentBytes - 1) / CommentBytes;
        int summaryRecord = 2 + commentRecords;
        int firstAddress = ((summaryRecord + 1) * RecordWords) + 1; // behind the records of summaries and names
        double[] data = [.. segments.SelectMany(segment => segment.Data)];
        stream.Write(FileRecord(idWord, summaryRecord, firstAddress + data.Length));
        Span<byte> record = stackalloc byte[RecordBytes];
        for (int i = 0; i < commentRecords; i++)
        {
            record.Clear();
            comment.AsSpan(i * CommentBytes, Math.Min(CommentBytes, comment.Length - (i * CommentBytes))).CopyTo(record);
            stream.Write(record);
        }

        stream.Write(SummaryRecord(segments, firstAddress));
        byte[] names = new byte[RecordBytes];
        names.AsSpan().Fill((byte)' ');
        for (int i = 0; i < segments.Count; i++)
        {
            Encoding.ASCII.GetBytes(Name, names.AsSpan(SummaryBytes * i));
        }

        stream.Write(names);
        WriteData(stream, data);
    }

    private static byte[] FileRecord(string idWord, int summaryRecord, int free)
    {
        byte[] record = new byte[RecordBytes];
        Encoding.ASCII.GetBytes(idWord.PadRight(8), record);
        BinaryPrimitives.WriteInt32LittleEndian(record.AsSpan(8), 2);
        BinaryPrimitives.WriteInt32LittleEndian(record.AsSpan(12), Integers);
        Encoding.ASCII.GetBytes(Name.PadRight(60), record.AsSpan(16));
        BinaryPrimitives.WriteInt32LittleEndian(record.AsSpan(76), summaryRecord);
        BinaryPrimitives.WriteInt32LittleEndian(record.AsSpan(80), summaryRecord);
        BinaryPrimitives.WriteInt32LittleEndian(record.AsSpan(84), free);
        "LTL-IEEE"u8.CopyTo(record.AsSpan(88));
        TransferMark.CopyTo(record.AsSpan(699));
        return record;
    }

    private static byte[] SummaryRecord(IReadOnlyList<DafSegment> segments, int firstAddress)
    {
        byte[] record = new byte[RecordBytes]; // no record before it, none after it
        BinaryPrimitives.WriteDoubleLittleEndian(record.AsSpan(16), segments.Count);
        Span<byte> summary = record.AsSpan(24);
        foreach (DafSegment segment in segments)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(summary, segment.First);
            BinaryPrimitives.WriteDoubleLittleEndian(summary[8..], segment.Last);
            int[] integers = [.. segment.Integers, firstAddress, firstAddress + segment.Data.Length - 1];
            for (int i = 0; i < integers.Length; i++)
            {
                BinaryPrimitives.WriteInt32LittleEndian(summary[(16 + (sizeof(int) * i))..], integers[i]);
            }

            firstAddress += segment.Data.Length;
            summary = summary[SummaryBytes..];
        }

        return record;
    }

    private static void WriteData(Stream stream, double[] data)
    {
        byte[] record = new byte[RecordBytes];
        for (int start = 0; start < data.Length; start += RecordWords)
        {
            record.AsSpan().Clear();
            for (int i = start; i < Math.Min(data.Length, start + RecordWords); i++)
            {
                BinaryPrimitives.WriteDoubleLittleEndian(record.AsSpan(sizeof(double) * (i - start)), data[i]);
            }

            stream.Write(record);
        }
    }
}

/// <summary>A segment of a binary kernel.</summary>
/// <param name="First">The first double of the summary.</param>
/// <param name="Last">The second one.</param>
/// <param name="Integers">The summary's first four integers; the addresses are put behind them.</param>
internal sealed record DafSegment(double First, double Last, int[] Integers, double[] Data);
