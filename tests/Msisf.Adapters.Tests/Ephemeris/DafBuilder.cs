using System.Buffers.Binary;
using System.Text;

namespace Msisf.Adapters.Tests.Ephemeris;

/// <summary>Writes small binary kernels, little- or big-endian, by NAIF's DAF Required Reading.</summary>
internal sealed class DafBuilder(string idWord, bool bigEndian = false)
{
    private const int RecordBytes = 1024;
    private readonly List<(double Start, double End, int[] Integers, double[] Data)> _segments = [];

    /// <summary>SPK type 2 or 3 with one record per entry: three constant components each.</summary>
    public DafBuilder AddSpk(int target, int center, double start, double recordSeconds, int type, params double[][] constants) =>
        Add(start, recordSeconds, [target, center, 1, type], seriesPerRecord: type == 3 ? 6 : 3, constants);

    /// <summary>PCK type 2 with one record per entry: three constant angles each.</summary>
    public DafBuilder AddPck(int body, double start, double recordSeconds, params double[][] constants) =>
        Add(start, recordSeconds, [body, 1, 2], seriesPerRecord: 3, constants);

    /// <summary>A segment as it is.</summary>
    public DafBuilder AddRaw(double start, double end, int[] integers, double[] data)
    {
        _segments.Add((start, end, integers, data));
        return this;
    }

    public byte[] ToArray()
    {
        int integers = idWord == "DAF/PCK" ? 5 : 6;
        byte[] bytes = new byte[(3 * RecordBytes) + (8 * _segments.Sum(segment => segment.Data.Length))];
        Encoding.ASCII.GetBytes(idWord.PadRight(8)).CopyTo(bytes, 0);
        WriteInt(bytes, 8, 2);
        WriteInt(bytes, 12, integers);
        WriteInt(bytes, 76, 2);
        WriteInt(bytes, 80, 2);
        Encoding.ASCII.GetBytes(bigEndian ? "BIG-IEEE" : "LTL-IEEE").CopyTo(bytes, 88);
        WriteDouble(bytes, RecordBytes + 16, _segments.Count);
        int address = (3 * RecordBytes / 8) + 1;
        int summary = RecordBytes + 24;
        foreach ((double start, double end, int[] values, double[] data) in _segments)
        {
            WriteDouble(bytes, summary, start);
            WriteDouble(bytes, summary + 8, end);
            int[] all = [.. values, address, address + data.Length - 1];
            for (int i = 0; i < all.Length; i++)
            {
                WriteInt(bytes, summary + 16 + (4 * i), all[i]);
            }

            for (int i = 0; i < data.Length; i++)
            {
                WriteDouble(bytes, 8 * (address - 1 + i), data[i]);
            }

            address += data.Length;
            summary += 16 + (8 * ((integers + 1) / 2));
        }

        return bytes;
    }

    private DafBuilder Add(double start, double recordSeconds, int[] integers, int seriesPerRecord, double[][] constants)
    {
        List<double> data = [];
        for (int i = 0; i < constants.Length; i++)
        {
            data.AddRange([start + ((i + 0.5) * recordSeconds), 0.5 * recordSeconds]);
            for (int series = 0; series < seriesPerRecord; series++)
            {
                // The second coefficient makes the value rise by 1 from the middle to the end; velocities are 99.
                data.AddRange(series < 3 ? [constants[i][series], 1.0] : [99.0, 99.0]);
            }
        }

        data.AddRange([start, recordSeconds, 2 + (2 * seriesPerRecord), constants.Length]);
        return AddRaw(start, start + (recordSeconds * constants.Length), integers, [.. data]);
    }

    private void WriteInt(byte[] bytes, int offset, int value)
    {
        Span<byte> target = bytes.AsSpan(offset);
        if (bigEndian)
        {
            BinaryPrimitives.WriteInt32BigEndian(target, value);
        }
        else
        {
            BinaryPrimitives.WriteInt32LittleEndian(target, value);
        }
    }

    private void WriteDouble(byte[] bytes, int offset, double value)
    {
        Span<byte> target = bytes.AsSpan(offset);
        if (bigEndian)
        {
            BinaryPrimitives.WriteDoubleBigEndian(target, value);
        }
        else
        {
            BinaryPrimitives.WriteDoubleLittleEndian(target, value);
        }
    }
}
