using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>One tile of a product that is published in many is a map of its own, whoever made it.</summary>
public sealed class MapTileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Parts of LDEM products: alone, beside others of an incomplete set, from the west, and across the prime meridian.</summary>
    [Theory]
    [InlineData(45, 0, 90, 180, false)]
    [InlineData(45, 0, 90, 180, true)]
    [InlineData(15, 0, 30, 60, true)]
    [InlineData(0, -45, -45, 0, false)]
    [InlineData(60, 30, 340, 385, false)]
    [InlineData(-75, -90, 330, 360, true)]
    public void Open_PartOfLdem_IsAMap(int north, int south, int west, int east, bool hasNeighbours)
    {
        string name = SplitModel.WritePart(_folder.Path, north, south, west, east);
        if (hasNeighbours)
        {
            SplitModel.WritePart(_folder.Path, north, south, west - 30, west);
        }

        LdemSet set = LdemCatalog.Read(_folder[name + ".LBL"]);
        Assert.Equal((false, 1), (set.IsWholeMoon, set.Parts.Count));
        using LdemMapImage map = LdemMapImage.Open(set);
        int first = (west + 360) % 360;
        Assert.Equal(new GridWindow(90 - north, 90 - south, first, first + east - west), map.Window);
        double[] radii = new double[east - west];
        foreach (int line in (int[])[map.Window.FirstLine, map.Window.EndLine - 1])
        {
            map.ReadRadii(line, first, radii);
            Assert.Equal(
                Enumerable.Range(west, east - west).Select(at => 1737400.0 + (0.5 * TestModel.ValueAt(line, (at + 360) % 360))),
                radii);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => map.ReadRadii(map.Window.FirstLine, first + 1, radii));
        Assert.Throws<ArgumentOutOfRangeException>(() => map.ReadRadii(map.Window.EndLine, first, radii));
    }

    /// <summary>A label of the whole Moon may begin anywhere.</summary>
    [Theory]
    [InlineData(-180)]
    [InlineData(-90)]
    [InlineData(30)]
    public void Open_WholeMoonFromAnyLongitude_HasItsSamples(int west)
    {
        string name = SplitModel.WritePart(_folder.Path, 90, -90, west, west + 360);
        using LdemImage image = LdemImage.Open(LdemCatalog.Read(_folder[name + ".LBL"]));
        double[] radii = new double[360];
        foreach ((int line, int first) in new[] { (0, 0), (77, 359), (179, (west + 360) % 360) })
        {
            image.ReadRadii(line, first, radii);
            Assert.Equal(
                Enumerable.Range(first, 360).Select(at => 1737400.0 + (0.5 * TestModel.ValueAt(line, at % 360))), radii);
        }
    }

    /// <summary>JAXA's tiles, whose labels are not LOLA's.</summary>
    [RequiresTheory(Part.GdalLibrary)]
    [InlineData("DTM_MAP_02_N12E018N09E021SC", "LSB_INTEGER", "METER", true, false, "758.083761")]
    [InlineData("DTM_MAPs02_N12E018N09E021SC", "MSB_INTEGER", "m", false, false, "758.084")]
    [InlineData("DTM_MAPs02_N12E018N09E021SC", "MSB_INTEGER", "METER", false, true, "758.0838")]
    public void Open_TileOfTerrainCamera_IsAMap(
        string name, string type, string unit, bool hasLimits, bool isAttached, string scale)
    {
        string path = WriteTile(name, type, unit, hasLimits, isAttached, scale);
        Assert.True(RasterFiles.IsForGdal(path));
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Equal(new Equirectangular(40), grid.Projection);
        Assert.Equal(new GridWindow(78 * 40, 81 * 40, 18 * 40, 21 * 40), grid.Window);
        Assert.Null(grid.NoteOfGaps());
        double[] radii = new double[120];
        for (int line = 0; line < 119; line += 17)
        {
            grid.ReadRadii(grid.Window.FirstLine + line, grid.Window.FirstSample, radii);
            Assert.Equal(Enumerable.Range(0, 120).Select(sample => 1_737_400.0 + TileValue(line, sample)), radii);
        }

        bool[] gap = new bool[120];
        grid.ReadGaps(grid.Window.FirstLine + 119, grid.Window.FirstSample, gap);
        Assert.Equal([119], Enumerable.Range(0, 120).Where(sample => gap[sample]));
    }

    /// <summary>An image of LOLA's without its label says by its name and its length what it is.</summary>
    [Theory]
    [InlineData("LDEM_1.IMG", false)]
    [InlineData("ldem_1_float.img", true)]
    public void Open_BareImage_IsRead(string name, bool hasFloats)
    {
        byte[] bytes = Bare(hasFloats);
        File.WriteAllBytes(_folder[name], bytes);
        Assert.False(RasterFiles.IsForGdal(_folder[name]));
        using (LdemImage image = LdemImage.Open(LdemCatalog.Read(_folder[name])))
        {
            double[] radii = new double[360];
            image.ReadRadii(89, 350, radii);
            Assert.All(
                Enumerable.Range(0, 360), i => Assert.Equal(1737400.0 + BareHeight(89, (350 + i) % 360), radii[i], 1e-3)); // floats of km
        }

        File.WriteAllBytes(_folder[name], bytes[1..]);
        Assert.Contains(
            "not a PDS3 label", Assert.Throws<BadInputException>(() => LdemCatalog.Read(_folder[name])).Message, StringComparison.Ordinal);
    }

    private static double BareHeight(int line, int sample) => -4000.0 + (25.0 * line) + (0.5 * sample);

    private static byte[] Bare(bool hasFloats)
    {
        byte[] bytes = new byte[180 * 360 * (hasFloats ? 4 : 2)];
        for (int i = 0; i < 180 * 360; i++)
        {
            double height = BareHeight(i / 360, i % 360);
            if (hasFloats)
            {
                BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(4 * i), (float)(height / 1000.0));
            }
            else
            {
                BinaryPrimitives.WriteInt16LittleEndian(bytes.AsSpan(2 * i), (short)Math.Round(height / 0.5));
            }
        }

        return bytes;
    }

    private static short TileValue(int line, int sample) => (short)(-2000 + (line * 7) + (sample * 3) + (line * sample % 5));

    private string WriteTile(string name, string type, string unit, bool hasLimits, bool isAttached, string scale)
    {
        const int Side = 120;
        const int LabelRecords = 20;
        string limits = hasLimits ? "MAXIMUM = -752.0\nMINIMUM = -2000.0\n" : string.Empty;
        string pointer = isAttached ? string.Create(CultureInfo.InvariantCulture, $"{LabelRecords + 1}") : $"\"{name}.img\"";
        string label = string.Create(CultureInfo.InvariantCulture, $"""
            PDS_VERSION_ID = PDS3
            RECORD_TYPE = FIXED_LENGTH
            RECORD_BYTES = {2 * Side}
            FILE_RECORDS = {(isAttached ? Side + LabelRecords : Side)}
            {(isAttached ? $"LABEL_RECORDS = {LabelRecords}" : "INTERCHANGE_FORMAT = BINARY")}
            ^IMAGE = {pointer}
            DATA_SET_ID = "SLN-L-TC-5-DTM-MAP-SEAMLESS-V2.0"
            PRODUCT_ID = "{name}"
            TARGET_NAME = MOON
            OBJECT = IMAGE
            LINES = {Side}
            LINE_SAMPLES = {Side}
            SAMPLE_TYPE = {type}
            SAMPLE_BITS = 16
            UNIT = "{unit}"
            SCALING_FACTOR = 1.0
            OFFSET = 0.0
            MISSING_CONSTANT = -9999
            {limits}END_OBJECT = IMAGE
            OBJECT = IMAGE_MAP_PROJECTION
            MAP_PROJECTION_TYPE = "SIMPLE CYLINDRICAL"
            MAP_RESOLUTION = 40 <pix/deg>
            A_AXIS_RADIUS = 1737.4 <km>
            B_AXIS_RADIUS = 1737.4 <km>
            C_AXIS_RADIUS = 1737.4 <km>
            POSITIVE_LONGITUDE_DIRECTION = "EAST"
            CENTER_LATITUDE = 0 <deg>
            CENTER_LONGITUDE = 0 <deg>
            MAP_PROJECTION_ROTATION = 0.0
            MAP_SCALE = {scale} <m/pix>
            MAXIMUM_LATITUDE = 12 <deg>
            MINIMUM_LATITUDE = 9 <deg>
            WESTERNMOST_LONGITUDE = 18 <deg>
            EASTERNMOST_LONGITUDE = 21 <deg>
            LINE_PROJECTION_OFFSET = 479.5 <pix>
            SAMPLE_PROJECTION_OFFSET = -720.5 <pix>
            COORDINATE_SYSTEM_NAME = "MEAN EARTH/POLAR AXIS OF DE421"
            END_OBJECT = IMAGE_MAP_PROJECTION
            END

            """).Replace("\n", "\r\n", StringComparison.Ordinal);
        byte[] image = new byte[2 * Side * Side];
        for (int i = 0; i < Side * Side; i++)
        {
            short value = i == (Side * Side) - 1 ? (short)-9999 : TileValue(i / Side, i % Side);
            if (type[0] == 'M')
            {
                BinaryPrimitives.WriteInt16BigEndian(image.AsSpan(2 * i), value);
            }
            else
            {
                BinaryPrimitives.WriteInt16LittleEndian(image.AsSpan(2 * i), value);
            }
        }

        byte[] head = Encoding.ASCII.GetBytes(label);
        if (isAttached)
        {
            Array.Resize(ref head, LabelRecords * 2 * Side);
            File.WriteAllBytes(_folder[name + ".dtm"], [.. head, .. image]);
            return _folder[name + ".dtm"];
        }

        File.WriteAllBytes(_folder[name + ".lbl"], head);
        File.WriteAllBytes(_folder[name + ".img"], image);
        return _folder[name + ".img"];
    }
}
