using System.Text;
using Msisf.Core.Layers;

namespace Msisf.Adapters.Layers;

/// <summary>
/// The head of a TIFF file (revision 6.0) that holds a layer: a page a plane, uncompressed, in strips of rows that follow each other. Files
/// whose offsets need more than 32 bits are BigTIFF. Everything but the numbers comes first, so that a file can be sent as it is made.
/// </summary>
internal static class TiffHead
{
    /// <summary>Rows of a strip: a reader takes it as a whole.</summary>
    private const int StripRows = 16;

    private const ushort Short = 3;
    private const ushort Long = 4;
    private const ushort Long8 = 16;
    private const ushort Ascii = 2;

    /// <param name="version">Version of the program.</param>
    /// <param name="description">Description of the layer.</param>
    public static byte[] Of(Layer layer, LayerType type, int width, int height, string version, string description)
    {
        long plane = (long)width * height * type.Size();
        bool isBig = (plane * layer.Planes) + EntriesOf(isBig: false, dataAt: 0).Sum(page => page.Length) > uint.MaxValue;
        int head = EntriesOf(isBig, dataAt: 0).Sum(page => page.Length);
        return [.. EntriesOf(isBig, head).SelectMany(page => page)];

        // The file's head, and that of each page; their lengths do not depend on the place of the numbers.
        List<byte[]> EntriesOf(bool isBig, long dataAt)
        {
            List<byte[]> parts = [isBig ? [.. "II"u8, 43, 0, 8, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0] : [.. "II"u8, 42, 0, 8, 0, 0, 0]];
            for (int page = 0; page < layer.Planes; page++)
            {
                long at = parts.Sum(part => part.Length);
                parts.Add(new TiffPage(isBig).ToBytes(PageOf(page, isBig, dataAt), at, isLast: page == layer.Planes - 1));
            }

            return parts;
        }

        IEnumerable<(ushort Tag, ushort Type, long[] Values, string? Text)> PageOf(int page, bool isBig, long dataAt)
        {
            int strips = (height + StripRows - 1) / StripRows;
            long strip = (long)width * StripRows * type.Size();
            string name = layer.Planes > 1 ? $" ({layer.PlaneNames[page]})" : string.Empty;
            string unit = layer.Unit.Length > 0 ? $" [{layer.Unit}]" : string.Empty;
            ushort offsets = isBig ? Long8 : Long;
            yield return (254, Long, [layer.Planes > 1 ? 2 : 0], null); // a page of several
            yield return (256, Long, [width], null);
            yield return (257, Long, [height], null);
            yield return (258, Short, [8 * type.Size()], null); // bits of a number
            yield return (259, Short, [1], null); // not compressed
            yield return (262, Short, [1], null); // small numbers are dark
            yield return (270, Ascii, [], $"{layer.Name}{name}{unit}: {description}");
            yield return (273, offsets, [.. Enumerable.Range(0, strips).Select(index => dataAt + (page * plane) + (index * strip))], null);
            yield return (277, Short, [1], null); // numbers of a pixel
            yield return (278, Long, [StripRows], null);
            yield return (279, offsets, [.. Enumerable.Range(0, strips).Select(index => Math.Min(strip, plane - (index * strip)))], null);
            yield return (297, Short, [page, layer.Planes], null);
            yield return (305, Ascii, [], $"MSISF {version}");
            yield return (339, Short, [type switch { LayerType.Unsigned8 => 1, LayerType.Signed32 => 2, _ => 3 }], null);
            if (type != LayerType.Unsigned8)
            {
                yield return (42113, Ascii, [], type == LayerType.Signed32 ? Invariant($"{Layer.UndefinedNumber}") : "nan"); // GDAL's
            }
        }
    }

    /// <summary>The directory of a page, and the values that do not fit into it.</summary>
    private sealed class TiffPage(bool isBig)
    {
        private int OffsetSize => isBig ? 8 : 4;

        public byte[] ToBytes(IEnumerable<(ushort Tag, ushort Type, long[] Values, string? Text)> entries, long at, bool isLast)
        {
            (ushort Tag, ushort Type, long Count, byte[] Value)[] all = [.. entries.Select(entry => (
                entry.Tag, entry.Type, entry.Text is null ? entry.Values.Length : Encoding.UTF8.GetByteCount(entry.Text) + 1L,
                entry.Text is null ? Numbers(entry.Type, entry.Values) : [.. Encoding.UTF8.GetBytes(entry.Text), 0]))];
            int length = (isBig ? 8 : 2) + (all.Length * (4 + (2 * OffsetSize))) + OffsetSize;
            long outside = at + length;
            using MemoryStream bytes = new();
            using BinaryWriter writer = new(bytes);
            Write(writer, all.Length, isBig ? 8 : 2);
            foreach ((ushort tag, ushort type, long count, byte[] value) in all)
            {
                writer.Write(tag);
                writer.Write(type);
                Write(writer, count, OffsetSize);
                if (value.Length > OffsetSize)
                {
                    Write(writer, outside, OffsetSize);
                    outside += Even(value.Length);
                }
                else
                {
                    writer.Write(value);
                    writer.Write(new byte[OffsetSize - value.Length]);
                }
            }

            Write(writer, isLast ? 0 : outside + Padding(outside), OffsetSize);
            foreach ((_, _, _, byte[] value) in all.Where(entry => entry.Value.Length > OffsetSize))
            {
                writer.Write(value);
                writer.Write(new byte[Even(value.Length) - value.Length]);
            }

            writer.Write(new byte[Padding(outside)]);
            return bytes.ToArray();
        }

        private static byte[] Numbers(ushort type, long[] values)
        {
            using MemoryStream bytes = new();
            using BinaryWriter writer = new(bytes);
            foreach (long value in values)
            {
                Write(writer, value, type switch { Short => 2, Long => 4, _ => 8 });
            }

            return bytes.ToArray();
        }

        private static void Write(BinaryWriter writer, long value, int size)
        {
            for (int index = 0; index < size; index++)
            {
                writer.Write((byte)(value >> (8 * index)));
            }
        }

        private static int Even(int length) => (length + 1) & ~1;

        /// <summary>Pages and numbers begin at multiples of 8.</summary>
        private static int Padding(long end) => (int)(-end & 7);
    }
}
