using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>The rasters of ../shared/field, whose right heights stand beside them.</summary>
public sealed class FieldRasterTests
{
    /// <summary>03: the whole Moon, in steps of 1 m of a formula.</summary>
    [RequiresTheory(Part.Field, Part.GdalLibrary)]
    [InlineData("lonlat_0_360.tif", true)]
    [InlineData("lonlat_0_360_without_last_row.tif", false)]
    public void Open_WholeMoonOfFormula_HasItsHeights(string name, bool isWhole)
    {
        using GeoTiffGrid grid = Open("03", name);
        Assert.Equal(isWhole, grid.AsWholeMoon() is not null);
        double[] radii = new double[720];
        for (int line = 0; line < 359; line += 7)
        {
            grid.ReadRadii(line, 0, radii);
            for (int sample = 0; sample < 720; sample++)
            {
                double latitude = double.DegreesToRadians(90.0 - ((line + 0.5) / 2.0));
                double longitude = double.DegreesToRadians((sample + 0.5) / 2.0);
                double height = (3000.0 * Math.Sin((12.0 * latitude) + 0.3) * Math.Cos((17.0 * longitude) + 0.5))
                    + (800.0 * Math.Cos(31.0 * latitude) * Math.Sin(29.0 * longitude)) + (200.0 * Math.Sin(5.0 * latitude));
                Assert.Equal(1_737_400.0 + height, radii[sample], 0.5 + 1e-6); // half a step
            }
        }
    }

    /// <summary>07: radii by the band's own scale and offset; what the refusal advises works.</summary>
    [RequiresFact(Part.Field, Part.GdalLibrary)]
    public void Open_RadiiByOffset_AreReadAsAdvised()
    {
        string message = Assert.Throws<BadInputException>(() => Open("07", "radii_by_offset.tif")).Message;
        Assert.Contains("add ,offset=-1737400 to its name", message, StringComparison.Ordinal);
        using GeoTiffGrid grid = Open("07", "radii_by_offset.tif", new HeightOptions(Scale: null, Offset: -1_737_400.0));
        Assert.Null(grid.NoteOfGaps());
        double[] radius = new double[1];
        GridWindow window = grid.Window;
        foreach ((int line, int sample) in new[] { (0, 0), (80, 80), (159, 3) })
        {
            grid.ReadRadii(window.FirstLine + line, window.FirstSample + sample, radius);
            double latitude = double.DegreesToRadians(22.0 - ((line + 0.5) / 32.0));
            double longitude = double.DegreesToRadians(33.0 + ((sample + 0.5) / 32.0));
            Assert.Equal(
                1_737_400.0 + (1000.0 * Math.Sin(40.0 * latitude) * Math.Cos(40.0 * longitude)) - 500.0, radius[0], 0.25 + 1e-6);
        }
    }

    /// <summary>08: a way to WGS 84 that moves nothing is no other map.</summary>
    [RequiresFact(Part.Field, Part.GdalLibrary)]
    public void Open_BoundSystemOfZeros_IsTheSameMap()
    {
        using GeoTiffGrid plain = Open("08", "site.tif");
        using GeoTiffGrid bound = Open("08", "site_towgs84.tif");
        Assert.Equal((plain.Projection, plain.Window), (bound.Projection, bound.Window));
        bool[] gaps = new bool[plain.Window.Samples];
        int compared = 0;
        for (int line = plain.Window.FirstLine; line < plain.Window.EndLine; line += 13)
        {
            plain.ReadGaps(line, plain.Window.FirstSample, gaps);
            for (int i = 0; i < gaps.Length; i += 7)
            {
                if (!gaps[i])
                {
                    double[] radii = new double[2];
                    plain.ReadRadii(line, plain.Window.FirstSample + i, radii.AsSpan(0, 1));
                    bound.ReadRadii(line, plain.Window.FirstSample + i, radii.AsSpan(1, 1));
                    Assert.Equal(radii[0], radii[1]);
                    compared++;
                }
            }
        }

        Assert.InRange(compared, 100, int.MaxValue);
    }

    /// <summary>10: -9999 is no ground, whether it is declared or not; only the latter is worth a note.</summary>
    [RequiresFact(Part.Field, Part.GdalLibrary)]
    public void Open_UndeclaredFill_IsAHoleWithANote()
    {
        using GeoTiffGrid declared = Open("10", "declared.tif");
        using GeoTiffGrid undeclared = Open("10", "undeclared.tif");
        Assert.Null(declared.NoteOfGaps());
        Assert.Contains("(-9999)", undeclared.NoteOfGaps(), StringComparison.Ordinal);
        bool[][] gaps = [new bool[128], new bool[128]];
        for (int line = declared.Window.FirstLine; line < declared.Window.EndLine; line++)
        {
            declared.ReadGaps(line, declared.Window.FirstSample, gaps[0]);
            undeclared.ReadGaps(line, declared.Window.FirstSample, gaps[1]);
            Assert.Equal(gaps[0], gaps[1]);
        }
    }

    /// <summary>29: one tile each of SLDEM2015, LDEM and Kaguya's Terrain Camera: LDEM_4, bilinear, raised.</summary>
    [RequiresTheory(Part.Field, Part.GdalLibrary, Part.Ldem4)]
    [InlineData("SLDEM2015_4_00N_30N_000_045_FLOAT.LBL", 150.0, 0.1)]
    [InlineData("LDEM_8_00N_15N_030_060.LBL", 90.0, 0.26)]
    [InlineData("DTM_MAPs02_N12E018N09E021SC.lbl", 120.0, 0.51)]
    [InlineData("DTM_MAPs02_N12E018N09E021SC.img", 120.0, 0.51)]
    public void Open_OneTile_IsLdem4Raised(string name, double raised, double step)
    {
        string path = Path.Combine(TestParts.Field!, "29", name);
        using LdemImage moon = LdemImage.Open(LdemCatalog.Read(TestParts.Ldem4Label!));
        using IDisposable file = RasterFiles.IsForGdal(path)
            ? GeoTiffGrid.Open(path, libraryPath: null)
            : LdemMapImage.Open(LdemCatalog.Read(path));
        ITerrainGrid tile = (ITerrainGrid)file;
        GridWindow window = tile.Window;
        (double[] radius, bool[] gap) = (new double[1], new bool[1]);
        int gaps = 0;
        for (int line = window.FirstLine; line < window.EndLine; line++)
        {
            for (int sample = window.FirstSample; sample < window.EndSample; sample++)
            {
                tile.ReadGaps(line, sample, gap);
                gaps += gap[0] ? 1 : 0;
                if (!gap[0] && (line + sample) % 11 == 0)
                {
                    tile.ReadRadii(line, sample, radius);
                    Assert.Equal(Bilinear(moon, tile.Projection, line, sample) + raised, radius[0], step);
                }
            }
        }

        Assert.Equal(name.StartsWith("DTM", StringComparison.Ordinal) ? 9 : 0, gaps);
    }

    private static double Bilinear(LdemImage moon, MapProjection projection, int line, int sample)
    {
        double degrees = 1.0 / ((Equirectangular)projection).PixelsPerDegree;
        (double y, double x) = (((line + 0.5) * degrees * 4.0) - 0.5, ((sample + 0.5) * degrees * 4.0) - 0.5);
        (int above, int left) = ((int)Math.Floor(y), (int)Math.Floor(x));
        (double down, double right) = (y - above, x - left);
        double[] upper = new double[2];
        double[] lower = new double[2];
        moon.ReadRadii(above, (left + 1440) % 1440, upper);
        moon.ReadRadii(above + 1, (left + 1440) % 1440, lower);
        return ((1.0 - down) * (upper[0] + (right * (upper[1] - upper[0])))) + (down * (lower[0] + (right * (lower[1] - lower[0]))));
    }

    private static GeoTiffGrid Open(string folder, string name, HeightOptions given = default) =>
        GeoTiffGrid.Open(Path.Combine(TestParts.Field!, folder, name), libraryPath: null, given);
}
