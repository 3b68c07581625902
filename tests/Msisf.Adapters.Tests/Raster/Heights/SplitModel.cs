using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>The samples of <see cref="TestModel"/> in several files, named and labelled as the archive does it.</summary>
internal static class SplitModel
{
    /// <summary>Writes all parts of a given size.</summary>
    /// <returns>Names of the parts, from the north-west.</returns>
    public static string[] Write(string folder, int heightDegrees, int widthDegrees)
    {
        List<string> names = [];
        for (int north = 90; north > -90; north -= heightDegrees)
        {
            for (int west = 0; west < 360; west += widthDegrees)
            {
                names.Add(WritePart(folder, north, north - heightDegrees, west, west + widthDegrees));
            }
        }

        return [.. names];
    }

    /// <summary>Writes one part.</summary>
    /// <returns>Its name.</returns>
    public static string WritePart(string folder, int north, int south, int west, int east)
    {
        string name = string.Create(
            CultureInfo.InvariantCulture, $"LDEM_1_{Latitude(south, north)}_{Latitude(north, north)}_{west:000}_{east:000}");
        File.WriteAllText(Path.Combine(folder, name + ".LBL"), LabelOf(name, north, south, west, east), Encoding.ASCII);
        byte[] bytes = new byte[(north - south) * (east - west) * sizeof(short)];
        for (int i = 0; i < bytes.Length / sizeof(short); i++)
        {
            short value = TestModel.ValueAt(90 - north + (i / (east - west)), (west + 360 + (i % (east - west))) % 360);
            BinaryPrimitives.WriteInt16LittleEndian(bytes.AsSpan(i * sizeof(short)), value);
        }

        File.WriteAllBytes(Path.Combine(folder, name + ".IMG"), bytes);
        return name;
    }

    private static string LabelOf(string name, int north, int south, int west, int east)
    {
        string label = TestModel.Label.Replace(
            "\"LDEM_1\"", $"\"{name}\"", StringComparison.Ordinal).Replace("LDEM_1.IMG", $"{name}.IMG", StringComparison.Ordinal);
        foreach ((string keyword, string was, double value) in new[]
        {
            ("FILE_RECORDS              =", "180", north - south),
            ("RECORD_BYTES              =", "720", 2.0 * (east - west)),
            ("LINES                 =", "180", north - south),
            ("LINE_SAMPLES          =", "360", east - west),
            ("LINE_LAST_PIXEL              =", "180", north - south),
            ("SAMPLE_LAST_PIXEL            =", "360", east - west),
            ("MAXIMUM_LATITUDE             =", "90", north),
            ("MINIMUM_LATITUDE             =", "-90", south),
            ("WESTERNMOST_LONGITUDE        =", "0", west),
            ("EASTERNMOST_LONGITUDE        =", "360", east),
            ("LINE_PROJECTION_OFFSET       =", "89.5", north - 0.5),
            ("SAMPLE_PROJECTION_OFFSET     =", "179.5", 180 - west - 0.5),
        })
        {
            label = label.Replace(
                $"{keyword} {was}", string.Create(CultureInfo.InvariantCulture, $"{keyword} {value}"), StringComparison.Ordinal);
        }

        return label;
    }

    private static string Latitude(int degrees, int north) =>
        string.Create(CultureInfo.InvariantCulture, $"{Math.Abs(degrees):00}{(degrees < 0 || (degrees == 0 && north == 0) ? 'S' : 'N')}");
}
