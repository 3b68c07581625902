using System.Buffers.Binary;
using System.Text;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

/// <summary>Ortho-images of LROC's narrow angle cameras: I/F by the label's scale, in any projection.</summary>
public sealed class NacImageTests : IDisposable
{
    private const int Lines = 40;
    private const int Samples = 60;
    private const string Angles = "INCIDENCE_ANGLE = 42.0 <DEG>\r\nEMISSION_ANGLE = 1.5 <DEG>\r\nPHASE_ANGLE = 41.0 <DEG>\r\n";
    private const string Polar = """
         MAP_PROJECTION_TYPE = "POLAR STEREOGRAPHIC"
         CENTER_LATITUDE = -90.0 <DEG>
         CENTER_LONGITUDE = 0.0 <DEG>
         LINE_PROJECTION_OFFSET = 2500.5 <PIXEL>
         SAMPLE_PROJECTION_OFFSET = -1500.5 <PIXEL>
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Pixel (0, 0) has its left upper corner at x = 30,000 m, y = 50,020 m, as GDAL reads the offsets.</summary>
    [RequiresTheory(Part.GdalLibrary)]
    [InlineData(true)]
    [InlineData(false)]
    public void OpenSeveral_LabelOfAPolarOrtho_HasItsReflectancesAndItsGeometry(bool isAttached)
    {
        string path = Write("NAC_DTM_SITE_M123_50CM", Polar, Angles, isAttached);

        using OpenedAlbedoMap site = Open(path, 0.1);

        Assert.Null(site.Factor);
        Assert.Equal(new ReferenceGeometry(42.0, 1.5, 41.0), site.Map.Reference);
        foreach ((int line, int sample) in new[] { (5, 5), (20, 30), (33, 54) })
        {
            (double x, double y) = (30_000.0 + (20.0 * (sample + 0.5)), 50_020.0 - (20.0 * (line + 0.5)));
            double latitude = -90.0 + double.RadiansToDegrees(2.0 * Math.Atan(0.5 * double.Hypot(x, y) / 1_737_400.0));
            double longitude = double.RadiansToDegrees(Math.Atan2(x, y));
            Assert.Equal(0.01 + (3e-5 * (1000 + sample)), At(site.Map, latitude, longitude), 4e-5); // of a pixel 3e-5
        }
    }

    /// <summary>Without angles the site is as bright as the map around; a geometry behind the path counts before the label's.</summary>
    [RequiresFact(Part.GdalLibrary)]
    public void OpenSeveral_NoAnglesOrOthers_AreMatchedOrTaken()
    {
        string plain = Write("NAC_ROI_PLAIN", Polar, string.Empty, isAttached: true);
        using (OpenedAlbedoMap site = Open(plain, 0.1))
        {
            Assert.Equal(0.1 / (0.01 + (3e-5 * 1029.5)), site.Factor!.Value, 0.02);
            Assert.Equal(new ReferenceGeometry(60.0, 0.0, 60.0), site.Map.Reference);
        }

        string angles = Write("NAC_ROI_ANGLES", Polar, Angles, isAttached: true);
        using (OpenedAlbedoMap site = Open($"{angles},incidence=30,emission=0,phase=30", 0.1))
        {
            Assert.Equal(new ReferenceGeometry(30.0, 0.0, 30.0), site.Map.Reference);
        }
    }

    [RequiresFact(Part.GdalLibrary)]
    public void OpenSeveral_EquirectangularAboutTheSite_IsWhereItLies()
    {
        const string about = """
             MAP_PROJECTION_TYPE = "EQUIRECTANGULAR"
             CENTER_LATITUDE = 20.0 <DEG>
             CENTER_LONGITUDE = 30.0 <DEG>
             LINE_PROJECTION_OFFSET = 30400.5 <PIXEL>
             SAMPLE_PROJECTION_OFFSET = -500.5 <PIXEL>
            """;
        using OpenedAlbedoMap site = Open(Write("NAC_DTM_ABOUT", about, Angles, isAttached: true), 0.1);

        // As GDAL has it: x = 10,000 m from 30 E along the parallel of 20 degrees, y = 608,020 m from the equator, in the corner.
        double perDegree = 1_737_400.0 * Math.PI / 180.0;
        (double x, double y) = (10_000.0 + (20.0 * 40.5), 608_020.0 - (20.0 * 15.5));
        double longitude = 30.0 + (x / perDegree / Math.Cos(double.DegreesToRadians(20.0)));
        Assert.Equal(0.01 + (3e-5 * 1040), At(site.Map, y / perDegree, longitude), 4e-5);
    }

    /// <summary>A GeoTIFF's own scale and offset make I/F of its numbers.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void OpenSeveral_GeoTiffWithAScale_HasItsReflectances()
    {
        string image = Write("NAC_DTM_SITE", Polar, string.Empty, isAttached: true);
        ChildRun.Of("gdal_translate", ["-q", image, _folder["site.tif"]], _folder.Path).Succeeded();

        using OpenedAlbedoMap site = Open($"{_folder["site.tif"]},scale=1,incidence=42,emission=2,phase=43", 0.1);

        double latitude = -90.0 + double.RadiansToDegrees(2.0 * Math.Atan(0.5 * double.Hypot(30_610.0, 49_610.0) / 1_737_400.0));
        Assert.Equal(0.01 + (3e-5 * 1030), At(site.Map, latitude, double.RadiansToDegrees(Math.Atan2(30_610.0, 49_610.0))), 4e-5);
    }

    [RequiresFact(Part.GdalLibrary)]
    public void OpenSeveral_AnglesThatCannotBe_AreRefused()
    {
        string path = Write("NAC_WRONG", Polar, Angles.Replace("41.0", "90.0", StringComparison.Ordinal), isAttached: true);

        Assert.Contains("no surface has incidence 42", Assert.Throws<BadInputException>(() => Open(path, 0.1)).Message);
    }

    private static double At(AlbedoMap map, double latitude, double longitude)
    {
        double right = (double.DegreesToRadians(longitude) - map.Extent.West) / map.Extent.Width;
        double down = (map.Extent.North - double.DegreesToRadians(latitude)) / map.Extent.Height;
        AlbedoMapLevel finest = map.Levels[0];
        int code = finest.Codes.Span[((int)(down * finest.Height) * finest.Width) + (int)(right * finest.Width)];
        Assert.NotEqual(0, code);
        return map.Offset + (map.Step * code);
    }

    private OpenedAlbedoMap Open(string site, double around)
    {
        string moon = PdsMap.Write(_folder, "WAC_A", "PC_REAL", 32, 1, (_, _) => around) + ",incidence=60,emission=0,phase=60";
        IReadOnlyList<OpenedAlbedoMap> maps = OpenedAlbedoMap.OpenSeveral(
            [AlbedoMapPath.Parse(moon), AlbedoMapPath.Parse(site)], 643, _folder["cache"], gdalPath: null);
        maps[0].Dispose();
        return maps[1];
    }

    /// <summary>An image whose numbers are 1000 and the sample; each is worth 3e-5, and 0.01 more.</summary>
    private string Write(string name, string projection, string angles, bool isAttached)
    {
        const int RecordBytes = 2 * Samples;
        const int LabelRecords = 20;
        string pointer = isAttached ? $"{LabelRecords + 1}" : $"\"{name}.IMG\"";
        string label =
            $"PDS_VERSION_ID = PDS3\r\nRECORD_TYPE = FIXED_LENGTH\r\nRECORD_BYTES = {RecordBytes}\r\n"
                + $"^IMAGE = {pointer}\r\nPRODUCT_ID = \"{name}\"\r\nTARGET_NAME = MOON\r\n{angles}OBJECT = IMAGE\r\n LINES = {Lines}\r\n"
                + $" LINE_SAMPLES = {Samples}\r\n SAMPLE_TYPE = LSB_INTEGER\r\n SAMPLE_BITS = 16\r\n BANDS = 1\r\n"
                + " SCALING_FACTOR = 3.0e-05\r\n OFFSET = 0.01\r\n MISSING_CONSTANT = -32768\r\n UNIT = \"I/F\"\r\nEND_OBJECT = IMAGE\r\n"
                + "OBJECT = IMAGE_MAP_PROJECTION\r\n A_AXIS_RADIUS = 1737.4 <KM>\r\n B_AXIS_RADIUS = 1737.4 <KM>\r\n"
                + " C_AXIS_RADIUS = 1737.4 <KM>\r\n POSITIVE_LONGITUDE_DIRECTION = EAST\r\n MAP_SCALE = 20.0 <METERS/PIXEL>\r\n"
                + $" MAP_RESOLUTION = 1516.16 <PIXEL/DEGREE>\r\n{projection.ReplaceLineEndings("\r\n")}\r\n"
                + "END_OBJECT = IMAGE_MAP_PROJECTION\r\nEND\r\n";
        byte[] samples = new byte[Lines * RecordBytes];
        for (int i = 0; i < Lines * Samples; i++)
        {
            BinaryPrimitives.WriteInt16LittleEndian(samples.AsSpan(2 * i), (short)(1000 + (i % Samples)));
        }

        if (!isAttached)
        {
            _folder.Write($"{name}.IMG", samples);
            return _folder.Write($"{name}.LBL", Encoding.ASCII.GetBytes(label));
        }

        return _folder.Write($"{name}.IMG", [.. Encoding.ASCII.GetBytes(label.PadRight(LabelRecords * RecordBytes)), .. samples]);
    }
}
