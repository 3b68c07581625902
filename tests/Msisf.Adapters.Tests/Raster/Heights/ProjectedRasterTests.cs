using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>
/// Rasters of the whole Moon, and of parts, in twelve projections, each with three conventions of longitudes. What a sample has to be comes
/// from a formula of latitude and longitude, with which PROJ (pyproj's library, by GDAL's Python) made the files.
/// </summary>
public sealed class ProjectedRasterTests(ProjectedRasters rasters) : IClassFixture<ProjectedRasters>
{
    /// <summary>m: the formula bends by so much between pixels that are two degrees apart, twice where rows lie farther apart.</summary>
    private const double BetweenPixels = 25.0;

    /// <summary>m: beside a pole heights are those of the last row, half a pixel away.</summary>
    private const double BesidePole = 120.0;

    /// <summary>m: rows of equal areas are 12 degrees wide there.</summary>
    private const double BesidePoleOfEqualAreas = 700.0;

    public static TheoryData<string, string, bool> Cases()
    {
        TheoryData<string, string, bool> cases = [];
        foreach ((string projection, bool isWhole) in ProjectedRasters.Projections)
        {
            foreach (string start in ProjectedRasters.Starts)
            {
                cases.Add(projection, start, isWhole);
            }
        }

        return cases;
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [MemberData(nameof(Cases))]
    public void Open_AnyProjectionAndStart_HasTheHeightsOfTheFormula(string projection, string start, bool isWhole)
    {
        using GeoTiffGrid grid = GeoTiffGrid.Open(rasters.PathOf(projection, start), libraryPath: null);
        Assert.Equal(isWhole, grid.AsWholeMoon() is not null);
        ITerrainGrid model = isWhole ? grid.AsWholeMoon()! : grid;
        GridWindow window = model.Window;
        double[] radius = new double[1];
        bool[] isGap = new bool[1];
        int compared = 0;
        Random random = new(1);
        for (int i = 0; i < 400; i++)
        {
            (int line, int sample) = (random.Next(window.FirstLine, window.EndLine), random.Next(window.FirstSample, window.EndSample));
            model.ReadGaps(line, sample, isGap);
            if (isGap[0])
            {
                continue;
            }

            model.ReadRadii(line, sample, radius);
            SelenographicPoint point = SelenographicPoint.Below(model.Projection.DirectionOf(line, sample));
            double expected = 1_737_400.0 + ProjectedRasters.HeightAt(point.Latitude, point.Longitude);
            double besidePole = projection.StartsWith("cea", StringComparison.Ordinal) ? BesidePoleOfEqualAreas : BesidePole;
            double tolerance = Math.Abs(point.Latitude) > 1.2 ? besidePole : BetweenPixels;
            Assert.Equal(expected, radius[0], tolerance);
            compared++;
        }

        Assert.InRange(compared, isWhole ? 400 : 150, 400);
    }

    /// <summary>A model of the whole Moon goes on across the prime meridian and across the file's own border.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [MemberData(nameof(Cases))]
    public void ReadRadii_AllOfALine_IsWhatItsSamplesAre(string projection, string start, bool isWhole)
    {
        using GeoTiffGrid grid = GeoTiffGrid.Open(rasters.PathOf(projection, start), libraryPath: null);
        if (!isWhole)
        {
            return; // of these the other test has looked at all there is
        }

        WholeGrid moon = grid.AsWholeMoon()!;
        int samples = ((ITerrainGrid)moon).Samples;
        (double[] all, double[] one) = (new double[samples], new double[1]);
        int line = ((ITerrainGrid)moon).Lines / 3;
        moon.ReadRadii(line, samples - 7, all);
        for (int i = 0; i < samples; i += 3)
        {
            moon.ReadRadii(line, (samples - 7 + i) % samples, one);
            Assert.Equal(one[0], all[i]);
        }

        KnownBounds bounds = moon.BoundsOf(line, 2, samples - 7, 14)!.Value;
        Assert.All(all.Take(14), radius => Assert.InRange(radius, bounds.Min, bounds.Max));
        Assert.InRange(
            Enumerable.Range(1, 13).Max(i => Math.Abs(all[i] - all[i - 1])), 0.0, bounds.Step + Rounding.OfPlaces);
    }
}

/// <summary>Writes the rasters of <see cref="ProjectedRasterTests"/>, all in one run of Python.</summary>
public sealed class ProjectedRasters : IDisposable
{
    /// <summary>Projections in PROJ's form, and whether the file has the whole Moon.</summary>
    public static readonly (string Projection, bool IsWhole)[] Projections =
    [
        ("longlat", true), ("eqc", true), ("eqc +lat_ts=40", true), ("cea", true), ("cea +lat_ts=30", true), ("mill", true),
        ("gall", true), ("patterson", true), ("merc", false), ("sinu", false), ("laea +lat_0=20", false), ("ortho +lat_0=-30", false),
    ];

    /// <summary>From -180, from 0, and from where nobody expects it.</summary>
    public static readonly string[] Starts = ["-180", "0", "77.3"];

    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        gdal.UseExceptions()
        R = 1737400.0
        def height(lat, lon):
            return 1500 * np.sin(3 * lat + 0.3) * np.cos(2 * lon + 0.5) + 300 * np.sin(7 * lon) * np.cos(lat)
        degrees = osr.SpatialReference()
        degrees.ImportFromProj4('+proj=longlat +R=1737400')
        for case in sys.argv[2:]:
            name, words, start, whole = case.split('|')
            start = float(start)
            middle = start + 180 if abs(start) % 180 == 0 else 0
            system = osr.SpatialReference()
            system.ImportFromProj4(f'+proj={words} +R=1737400' + ('' if words == 'longlat' else f' +lon_0={middle}'))
            for one in (degrees, system):
                one.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
            there, back = osr.CoordinateTransformation(degrees, system), osr.CoordinateTransformation(system, degrees)
            columns, rows = 180, 90
            if words.split()[0] in ('longlat', 'eqc', 'cea', 'mill', 'gall', 'patterson', 'merc'):
                x = [there.TransformPoint(middle + d, 0.0)[0] for d in (-45, 45)]
                turn = 2 * (x[1] - x[0]) * 2
                top = there.TransformPoint(middle, 84.0 if words == 'merc' else 90.0)[1]
                left = (start if words == 'longlat' else turn * (start - middle) / 360)
                across, down = turn / columns, 2 * top / rows
                y = top - down * (np.arange(rows) + 0.5)
                at = there.TransformPoint(middle, 0.0)[0]
                lat = np.radians([back.TransformPoint(at, float(v))[1] for v in y])[:, None]
                lon = np.radians((start + 360 * (np.arange(columns) + 0.5) / columns) if words == 'longlat' else
                                 middle + 360 * (left + across * (np.arange(columns) + 0.5)) / turn)[None, :]
                values = height(lat, lon)
            else:
                half = 700e3
                left, top, across, down = -half, half, 2 * half / columns, 2 * half / rows
                values = np.full((rows, columns), -32768.0)
                for i in range(rows):
                    for j in range(columns):
                        px, py = left + across * (j + 0.5), top - down * (i + 0.5)
                        lon, lat, _ = back.TransformPoint(px, py)
                        if np.isfinite(lon) and np.isfinite(lat):
                            values[i, j] = height(np.radians(lat), np.radians(lon))
            data = gdal.GetDriverByName('GTiff').Create(f'{sys.argv[1]}/{name}.tif', columns, rows, 1, gdal.GDT_Int16)
            band = data.GetRasterBand(1)
            band.SetScale(0.5)
            band.SetOffset(10.0)
            band.SetNoDataValue(-32768)
            band.WriteArray(np.where(values <= -32768, -32768, np.round((values - 10) / 0.5)).astype('i2'))
            data.SetGeoTransform([left, across, 0, top, 0, -down])
            data.SetProjection(system.ExportToWkt())
        """;

    private readonly TemporaryFolder _folder = new();
    private bool _isMade;

    /// <summary>The height of the rasters, m.</summary>
    public static double HeightAt(double latitude, double longitude) =>
        (1500.0 * Math.Sin((3.0 * latitude) + 0.3) * Math.Cos((2.0 * longitude) + 0.5))
            + (300.0 * Math.Sin(7.0 * longitude) * Math.Cos(latitude));

    /// <summary>The file of a case.</summary>
    public string PathOf(string projection, string start)
    {
        if (!_isMade)
        {
            string[] cases = [.. Projections.SelectMany(one => Starts.Select(
                from => $"{NameOf(one.Projection, from)}|{one.Projection}|{from}|{one.IsWhole}"))];
            ChildRun.Of(TestParts.Python!, ["-c", Script, _folder.Path, .. cases], _folder.Path).Succeeded();
            _isMade = true;
        }

        return _folder[NameOf(projection, start) + ".tif"];
    }

    public void Dispose() => _folder.Dispose();

    private static string NameOf(string projection, string start) =>
        string.Create(CultureInfo.InvariantCulture, $"{projection.Replace(" ", string.Empty, StringComparison.Ordinal)}{start}");
}
