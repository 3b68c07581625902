using System.Buffers.Binary;
using System.Text;

namespace Msisf.Stress.Fuzz;

/// <summary>
/// A GeoTIFF of the south pole of 24 x 24 heights in 32-bit floats, 25 km a pixel, in one strip without compression: small enough that
/// damage often falls on its tags. The keys are those of OGC's GeoTIFF standard 1.1.
/// </summary>
internal static class TinyGeoTiff
{
    private const int Side = 24;
    private const double Scale = 25_000.0; // m a pixel
    private const double Radius = 1_737_400.0; // m
    private const ushort Short = 3;
    private const ushort Long = 4;
    private const ushort Double = 12;
    private const ushort Ascii = 2;
    private const ushort UserDefined = 32767;
    private const ushort InDoubles = 34736;

    /// <summary>The bytes of the file.</summary>
    public static byte[] Bytes()
    {
        (ushort Tag, ushort Type, int Count, byte[] Value)[] entries =
        [
            (256, Short, 1, Shorts(Side)), // width
            (257, Short, 1, Shorts(Side)), // height
            (258, Short, 1, Shorts(32)), // bits a sample
            (259, Short, 1, Shorts(1)), // no compression
            (262, Short, 1, Shorts(1)), // 0 is black
            (273, Long, 1, Longs(0)), // where the samples are: set below
            (277, Short, 1, Shorts(1)), // samples a pixel
            (278, Short, 1, Shorts(Side)), // rows of a strip
            (279, Long, 1, Longs(4 * Side * Side)),
            (339, Short, 1, Shorts(3)), // floats
            (33550, Double, 3, Doubles(Scale, Scale, 0.0)),
            (33922, Double, 6, Doubles(0.0, 0.0, 0.0, -0.5 * Side * Scale, 0.5 * Side * Scale, 0.0)),
            .. Keys(),
            (42113, Ascii, 6, Encoding.ASCII.GetBytes("-9999\0")), // no data
        ];
        int values = 8 + 2 + (12 * entries.Length) + 4;
        int samples = values + entries.Sum(entry => entry.Value.Length > 4 ? entry.Value.Length : 0);
        byte[] file = new byte[samples + (4 * Side * Side)];
        Encoding.ASCII.GetBytes("II*\0").CopyTo(file, 0);
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(4), 8);
        BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(8), (short)entries.Length);
        for (int i = 0; i < entries.Length; i++)
        {
            (ushort tag, ushort type, int count, byte[] value) = entries[i];
            Span<byte> entry = file.AsSpan(10 + (12 * i), 12);
            BinaryPrimitives.WriteUInt16LittleEndian(entry, tag);
            BinaryPrimitives.WriteUInt16LittleEndian(entry[2..], type);
            BinaryPrimitives.WriteInt32LittleEndian(entry[4..], count);
            if (value.Length <= 4)
            {
                (tag == 273 ? Longs(samples) : value).CopyTo(entry[8..]);
                continue;
            }

            BinaryPrimitives.WriteInt32LittleEndian(entry[8..], values);
            value.CopyTo(file, values);
            values += value.Length;
        }

        for (int i = 0; i < Side * Side; i++)
        {
            BinaryPrimitives.WriteSingleLittleEndian(file.AsSpan(samples + (4 * i)), (i * 7919 % 4001) - 2000);
        }

        return file;
    }

    /// <summary>
    /// Polar stereographic on a sphere. A key is its number, the tag of its value or 0, how many values, and the value or its place.
    /// </summary>
    private static (ushort, ushort, int, byte[])[] Keys() =>
    [
        (34735, Short, 4 * 16, Shorts(
            1, 1, 0, 15,
            1024, 0, 1, 1, // a projected map
            1025, 0, 1, 1, // pixels are areas
            2048, 0, 1, UserDefined,
            2050, 0, 1, UserDefined,
            2054, 0, 1, 9102, // degrees
            2056, 0, 1, UserDefined,
            2057, InDoubles, 1, 0, // the sphere's radius
            2058, InDoubles, 1, 0,
            3072, 0, 1, UserDefined,
            3074, 0, 1, UserDefined,
            3075, 0, 1, 15, // polar stereographic
            3076, 0, 1, 9001, // metres
            3081, InDoubles, 1, 1, // latitude of the pole
            3092, InDoubles, 1, 2, // scale there
            3095, InDoubles, 1, 3)), // longitude along the y axis
        (34736, Double, 4, Doubles(Radius, -90.0, 1.0, 0.0)),
    ];

    private static byte[] Shorts(params int[] values) => [.. values.SelectMany(value => BitConverter.GetBytes((ushort)value))];

    private static byte[] Longs(params int[] values) => [.. values.SelectMany(BitConverter.GetBytes)];

    private static byte[] Doubles(params double[] values) => [.. values.SelectMany(BitConverter.GetBytes)];
}
