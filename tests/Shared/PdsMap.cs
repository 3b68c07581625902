using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace Msisf.TestSupport;

/// <summary>Writes PDS3 maps of the Moon with attached labels.</summary>
internal static class PdsMap
{
    private const int LabelBytes = 2048;

    /// <summary>Writes a map.</summary>
    /// <param name="folder">Where to.</param>
    /// <param name="product">Its name.</param>
    /// <param name="type">SAMPLE_TYPE.</param>
    /// <param name="bits">SAMPLE_BITS.</param>
    /// <param name="perDegree">Pixels a degree.</param>
    /// <param name="valueOf">Stored value of a column and row.</param>
    /// <param name="more">Further lines of the IMAGE object.</param>
    /// <param name="west">Left edge, degrees.</param>
    /// <param name="north">Upper edge, degrees.</param>
    /// <param name="degrees">Width and height, degrees.</param>
    public static string Write(
        TemporaryFolder folder, string product, string type, int bits, int perDegree, Func<int, int, double> valueOf, string more = "",
        double west = 0.0, double north = 90.0, (int Width, int Height)? degrees = null)
    {
        (int width, int height) = degrees is { } part ? (part.Width * perDegree, part.Height * perDegree) : (360 * perDegree,
            180 * perDegree);
        string label = string.Create(
            CultureInfo.InvariantCulture,
            $"PDS_VERSION_ID = PDS3\r\nRECORD_BYTES = {LabelBytes}\r\n^IMAGE = 2\r\nPRODUCT_ID = \"{product}\"\r\n"
                + $"OBJECT = IMAGE\r\n LINES = {height}\r\n LINE_SAMPLES = {width}\r\n SAMPLE_TYPE = {type}\r\n SAMPLE_BITS = {bits}\r\n"
                + $" {more}\r\n"
                + $"END_OBJECT = IMAGE\r\nOBJECT = IMAGE_MAP_PROJECTION\r\n MAP_PROJECTION_TYPE = \"EQUIRECTANGULAR\"\r\n"
                + $" MAP_RESOLUTION = {perDegree} <PIX/DEG>\r\n WESTERNMOST_LONGITUDE = {west} <DEG>\r\n"
                + $" MAXIMUM_LATITUDE = {north} <DEG>\r\nEND_OBJECT = IMAGE_MAP_PROJECTION\r\nEND\r\n");
        byte[] bytes = new byte[LabelBytes + (width * height * bits / 8)];
        Encoding.ASCII.GetBytes(label, bytes);
        for (int i = 0; i < width * height; i++)
        {
            Span<byte> sample = bytes.AsSpan(LabelBytes + (i * bits / 8));
            double value = valueOf(i % width, i / width);
            switch (type.Trim('"').Replace(' ', '_').ToUpperInvariant(), bits)
            {
                case (_, 8): sample[0] = (byte)value; break;
                case ("LSB_INTEGER", 16): BinaryPrimitives.WriteInt16LittleEndian(sample, (short)value); break;
                case ("MSB_UNSIGNED_INTEGER", 16): BinaryPrimitives.WriteUInt16BigEndian(sample, (ushort)value); break;
                case ("PC_REAL", 32): BinaryPrimitives.WriteSingleLittleEndian(sample, (float)value); break;
                default: BinaryPrimitives.WriteSingleBigEndian(sample, (float)value); break;
            }
        }

        return folder.Write($"{product}.IMG", bytes);
    }
}
