using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Which cells <c>msis illumination</c> takes for a region, as the file beside the arrays tells it.</summary>
public sealed partial class IlluminationRegionTests : IDisposable
{
    private const double Radius = 1_737_400.0;
    private const double DegreesOfPixel = 0.25; // LDEM_4

    private static readonly string[] When = ["--time-interval", "61041:12h:61043", "--ephemeris", "builtin", "--batch"];

    /// <summary>More parts than there are: the region is found, and nothing else is to be done.</summary>
    private static readonly string[] NoWork = ["--piece", "10000/10000"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Great circles through the middle of the region, between its edges; each side within a cell at most.</summary>
    [Theory]
    [InlineData(44.9, 30.0, 60.0, 40.0)]
    [InlineData(-44.9, 359.0, 60.0, 40.0)]
    [InlineData(0.0, 180.0, 40.0, 60.0)]
    [InlineData(45.1, 30.0, 60.0, 40.0)]
    [InlineData(-60.0, 200.0, 40.0, 60.0)]
    public void Size_IsOnTheGround(double latitude, double longitude, double width, double height)
    {
        Region region = Find(
            "a", Invariant($"--center={latitude:R},{longitude:R}"), "--size", Invariant($"{width:R},{height:R}"), "--cell", "2000");
        Assert.Equal((width / 2.0, height / 2.0), (region.Samples, region.Lines));
        (double line, double sample) = (0.5 * region.Lines, 0.5 * region.Samples);
        double across = Distance(region.At(line, 0.0), region.At(line, region.Samples));
        double down = Distance(region.At(0.0, sample), region.At(region.Lines, sample));
        Assert.Equal(width, across, 0.003 * width); // the region's middle is off by half a cell, and the scale is not the same all over
        Assert.Equal(height, down, 0.003 * height);
        Assert.InRange(Distance(region.At(line, sample), (latitude, longitude)), 0.0, 2.0);
    }

    /// <summary>At the pole a metre on the map is one on the ground.</summary>
    [Fact]
    public void Cell_AroundThePole_IsThatOfTheMap()
    {
        Region region = Find("a", "--center", "-90,77", "--size", "48,24", "--cell", "2400");
        Assert.Equal(new Region(10, 20, -24_000.0, 12_000.0, 2400.0, 2400.0, "IAU_2015:30135"), region);
    }

    [Fact]
    public void NoCell_OfACylindricalModel_IsItsPixel()
    {
        Region region = Find("a", "--center", "10,20.03", "--size", "100");

        Assert.Equal((DegreesOfPixel, DegreesOfPixel), (region.CellWidth, region.CellHeight));
        Assert.Equal(0.0, Math.IEEERemainder(region.Left, DegreesOfPixel));
        Assert.Equal(0.0, Math.IEEERemainder(region.Top, DegreesOfPixel));
        Assert.Equal((100.0 / 7.58 / Math.Cos(10.0 * Math.PI / 180.0), 100.0 / 7.58), (region.Samples, region.Lines), new WithinHalf());
    }

    /// <summary>The pixels of a polar map, whose pole is off the middle of its raster.</summary>
    [Theory]
    [InlineData("south")]
    [InlineData("north")]
    public void NoCell_OfAPolarModel_IsItsPixel(string pole)
    {
        string label = PolarMap(pole);
        string sign = pole == "south" ? "-" : string.Empty;
        Region region = Find("a", $"--center={sign}89.5,100", "--size", "20,10", "--ldem", TestParts.Ldem4Label!, "--ldem", label);
        Assert.Equal((1000.0, 1000.0, 20, 10), (region.CellWidth, region.CellHeight, region.Samples, region.Lines));

        // A label's offsets are those of the pole from the middle of the first pixel, in pixels.
        double edge = 1000.0 * (Value(label, "SAMPLE_PROJECTION_OFFSET") + 0.5);
        Assert.Equal(0.0, Math.IEEERemainder(region.Left + edge, 1000.0), 1e-6);
        edge = 1000.0 * (Value(label, "LINE_PROJECTION_OFFSET") + 0.5);
        Assert.Equal(0.0, Math.IEEERemainder(region.Top - edge, 1000.0), 1e-6);

        // Far from it the other model has the finest pixels.
        Region far = Find("b", "--center", "10,20", "--size", "100", "--ldem", TestParts.Ldem4Label!, "--ldem", label);
        Assert.Equal(DegreesOfPixel, far.CellWidth);
    }

    /// <summary>Without --cell and with it: the maps on both sides of longitude 0 have one border, and a map across it goes on.</summary>
    [Theory]
    [InlineData(null)]
    [InlineData("9000")]
    public void Corners_OnBothSidesOfLongitude0_Meet(string? cell)
    {
        string[] size = cell is null ? [] : ["--cell", cell];
        Region west = Find("a", ["--corners", "10,356,12,360", .. size]);
        Region east = Find("b", ["--corners", "10,0,12,4", .. size]);
        Region across = Find("c", ["--corners", "10,356,12,4", .. size]);
        Region signed = Find("d", ["--corners", "12,-4,10,4", .. size]);

        Assert.Equal(0.0, west.Left + (west.Samples * west.CellWidth), 1e-12);
        Assert.Equal(0.0, east.Left);
        Assert.Equal((west.CellWidth, west.Top, west.Lines), (east.CellWidth, east.Top, east.Lines));
        Assert.Equal((west.Left, west.Samples + east.Samples), (across.Left, across.Samples));
        Assert.Equal(across, signed);
    }

    /// <summary>A map alone: cells beyond the outermost samples have no data, in all maps; a region beside it is an error.</summary>
    [Fact]
    public void Region_OverTheEdgeOfAModel_HasNoDataThere()
    {
        string label = PolarMap("south");
        int side = (int)Value(label, " LINES");
        double half = 0.5 * 1000.0 * (side - 1); // m: from the pole to the outermost samples
        double latitude = -90.0 + double.RadiansToDegrees(half / Radius);
        CommandLineRun run = Run("a", Invariant($"--center={latitude:R},0"), "--size", "9,5", "--cell", "1000", "--ldem", label);
        Assert.True(run.ExitCode == 0, run.Error);
        Region region = Region.Read(_folder["a/maps.json"]);
        float[] lit = Read("a/lit.npy");
        int outside = 0;
        for (int i = 0; i < lit.Length; i++)
        {
            double y = region.Top - (((i / region.Samples) + 0.5) * region.CellHeight);
            double x = region.Left + (((i % region.Samples) + 0.5) * region.CellWidth);
            bool isInside = Math.Max(Math.Abs(x), Math.Abs(y)) < half;
            Assert.Equal(isInside, float.IsFinite(lit[i]));
            outside += isInside ? 0 : 1;
        }

        Assert.InRange(outside, 9, 36);
        foreach (string path in Directory.GetFiles(_folder["a"], "*.npy"))
        {
            Assert.True(Read(path).Zip(lit).All(pair => float.IsFinite(pair.Second) || float.IsNaN(pair.First)), path);
        }

        Assert.Contains(Invariant($"of {lit.Length - outside} cells"), run.Error, StringComparison.Ordinal);
        Assert.Contains(Invariant($"{outside} cells lie outside the models and have no data."), run.Error, StringComparison.Ordinal);
        Assert.Equal(Read("a/lit.npy"), Again("a", run, latitude, label));

        CommandLineRun beside = Run("b", "--center", "-70,0", "--size", "9,5", "--cell", "1000", "--ldem", label);
        Assert.Equal((2, string.Empty), (beside.ExitCode, beside.Output));
        Assert.Contains("Choose a region inside them, or give a model of the whole Moon as well.", beside.Error, StringComparison.Ordinal);
    }

    /// <summary>Both ways that the error names are gone.</summary>
    [Theory]
    [InlineData("-89,0", "400", "10")]
    [InlineData("20,300", "900,30", "5")]
    public void TooManyCells_WhatTheErrorAdvises_Works(string centre, string size, string cell)
    {
        CommandLineRun run = Run("a", [$"--center={centre}", "--size", size, "--cell", cell]);
        Assert.Equal((1, string.Empty), (run.ExitCode, run.Output));
        Match advice = Advice().Match(run.Error);
        Assert.True(advice.Success, run.Error);
        Assert.Contains("4000000 cells are the limit", run.Error, StringComparison.Ordinal);

        CommandLineRun wider = Run("b", [$"--center={centre}", "--size", size, "--cell", advice.Groups["cell"].Value, .. NoWork]);
        CommandLineRun part = Run("c", [$"--center={centre}", "--size", advice.Groups["size"].Value, "--cell", cell, .. NoWork]);
        Assert.True(wider.ExitCode == 0, wider.Error);
        Assert.True(part.ExitCode == 0, part.Error);

        // A hundredth less is too fine, and the parts cover the region.
        string finer = Invariant($"{0.98 * double.Parse(advice.Groups["cell"].Value, CultureInfo.InvariantCulture)}");
        Assert.Equal(1, Run("d", [$"--center={centre}", "--size", size, "--cell", finer, .. NoWork]).ExitCode);
        double[] whole = [.. size.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];
        double[] parts = [.. advice.Groups["size"].Value.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];
        double count = double.Parse(advice.Groups["parts"].Value, CultureInfo.InvariantCulture);
        Assert.InRange(count * parts[0], whole[0], 1.1 * whole[0]);
        Assert.InRange(count * parts[1], whole[^1], 1.1 * whole[^1]);
    }

    [Theory]
    [InlineData("--center", "46,0", "--size", "4000", "--cell", "20000", "The region leads over the equator: a polar map ends there.")]
    [InlineData("--corners", "80,0,20,10", "--cell", "20000", null, null, null)]
    [InlineData("--center", "-40,0", "--size", "4000", "--cell", "20000", "leads over a pole")]
    public void Region_ThatNoMapHolds_IsRefused(params string?[] words)
    {
        string? message = words[^1];
        CommandLineRun run = Run("a", [.. words[..^1].OfType<string>(), .. NoWork]);
        Assert.Equal(message is null ? 0 : 1, run.ExitCode);
        Assert.True(message is null || run.Error.Contains(message, StringComparison.Ordinal), run.Error);
    }

    /// <summary>Of the times of the longest light and the longest night there are none where there is no light, or no night.</summary>
    [Fact]
    public void StartAndEnd_OfNoTime_HaveNoData()
    {
        CommandLineRun run = Run("a", "--center", "-89.6,100", "--size", "60", "--cell", "4000");
        Assert.True(run.ExitCode == 0, run.Error);
        foreach (string name in (string[])["light", "dark"])
        {
            float[] hours = Read($"a/longest_{name}.npy");
            Assert.Contains(0.0f, hours);
            Assert.Contains(hours, value => value > 0.0f);
            foreach (string end in (string[])["start", "end"])
            {
                Assert.All(
                    Read($"a/longest_{name}_{end}.npy").Zip(hours),
                    pair => Assert.Equal(pair.Second > 0.0f, float.IsFinite(pair.First)));
            }
        }
    }

    [GeneratedRegex(@"Take --cell (?<cell>\S+) or wider, or cut the region into (?<parts>\d+) x \d+ of --size (?<size>\S+)\.")]
    private static partial Regex Advice();

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);

    private static double Value(string label, string key) => double.Parse(
        File.ReadLines(label).First(line => line.Contains($"{key} ", StringComparison.Ordinal)).Split('=')[1].Split('<')[0],
        CultureInfo.InvariantCulture);

    /// <summary>km, by the haversine formula.</summary>
    private static double Distance((double Latitude, double Longitude) a, (double Latitude, double Longitude) b)
    {
        (double latitude, double other) = (double.DegreesToRadians(a.Latitude), double.DegreesToRadians(b.Latitude));
        double up = Math.Sin(0.5 * (latitude - other));
        double across = Math.Sin(0.5 * double.DegreesToRadians(a.Longitude - b.Longitude));
        return 2e-3 * Radius * Math.Asin(Math.Sqrt((up * up) + (Math.Cos(latitude) * Math.Cos(other) * across * across)));
    }

    private float[] Again(string folder, CommandLineRun run, double latitude, string label)
    {
        Assert.Equal(run.Output, Run(
            folder, Invariant($"--center={latitude:R},0"), "--size", "9,5", "--cell", "1000", "--ldem", label).Output);
        return Read($"{folder}/lit.npy");
    }

    private string PolarMap(string pole)
    {
        Assert.Equal(0, CommandLineRun.Of(
            [
                "ldem", "synthesize", "--projection", $"polar-{pole}", "--map-scale", "1000", "--latitude", "89", "--seed", "1",
                "--output-dir", _folder.Path,
            ]).ExitCode);
        return Directory.GetFiles(_folder.Path, "*.LBL").Single();
    }

    private Region Find(string folder, params string[] place)
    {
        CommandLineRun run = Run(folder, place);
        Assert.True(run.ExitCode == 0, run.Error);
        return Region.Read(_folder[$"{folder}/maps.json"]);
    }

    private CommandLineRun Run(string folder, params string[] arguments) =>
        CommandLineRun.Of(["illumination", .. arguments, .. When, "--output-dir", _folder[folder]]);

    private float[] Read(string name)
    {
        byte[] bytes = File.ReadAllBytes(Path.IsPathRooted(name) ? name : _folder[name]);
        return MemoryMarshal.Cast<byte, float>(bytes.AsSpan(10 + BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(8)))).ToArray();
    }

    /// <summary>Counts that are rounded.</summary>
    private sealed class WithinHalf : IEqualityComparer<(double, double)>
    {
        public bool Equals((double, double) x, (double, double) y) =>
            Math.Abs(x.Item1 - y.Item1) <= 0.5 && Math.Abs(x.Item2 - y.Item2) <= 0.5;

        public int GetHashCode((double, double) obj) => 0;
    }

    private sealed record Region(int Lines, int Samples, double Left, double Top, double CellWidth, double CellHeight, string Crs)
    {
        public static Region Read(string path)
        {
            JsonElement root = JsonDocument.Parse(File.ReadAllText(path)).RootElement;
            double Number(string name) => root.GetProperty(name).GetDouble();
            return new Region(
                (int)Number("lines"), (int)Number("samples"), Number("left"), Number("top"), Number("cellWidth"), Number("cellHeight"),
                root.GetProperty("crs").GetString()!);
        }

        /// <summary>Degrees; on polar maps by J. Snyder, USGS PP 1395 (1987), equations 20-14 to 20-18.</summary>
        public (double Latitude, double Longitude) At(double line, double sample)
        {
            (double x, double y) = (Left + (sample * CellWidth), Top - (line * CellHeight));
            if (Crs == "IAU_2015:30100")
            {
                return (y, x);
            }

            double sign = Crs == "IAU_2015:30130" ? 1.0 : -1.0;
            double polar = double.RadiansToDegrees(2.0 * Math.Atan2(Math.Sqrt((x * x) + (y * y)), 2.0 * Radius));
            return (sign * (90.0 - polar), double.RadiansToDegrees(Math.Atan2(x, -sign * y)));
        }
    }
}
