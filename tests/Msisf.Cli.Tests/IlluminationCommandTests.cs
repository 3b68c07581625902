using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using Msisf.Adapters.Input;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

public sealed class IlluminationCommandTests : IDisposable
{
    private static readonly string[] Where = ["--center", "-89.6,100", "--size", "4,3", "--cell", "500"];
    private static readonly string[] When = ["--time-interval", "2026-01-01T00:00:00Z:6h:2026-02-01T00:00:00Z"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Maps have the region's shape and agree with each other; a call that finds the horizons of pieces writes the same.</summary>
    [Fact]
    public void Region_TwiceAndInPieces_HasTheSameMaps()
    {
        CommandLineRun first = Run("a", [.. Where, .. When, "--above-ground", "0,10"]);
        Assert.Equal(0, first.ExitCode);
        float[] lit = Read("a", "lit_0m.npy");
        float[] disc = Read("a", "disc_0m.npy");
        Assert.Equal(8 * 6, lit.Length);
        Assert.All(lit.Zip(disc), pair => Assert.InRange(pair.Second, 0.0f, pair.First));
        Assert.True(Read("a", "lit_10m.npy").Sum() >= lit.Sum());
        Assert.All(lit.Zip(Read("a", "never_lit_0m.npy")), pair => Assert.Equal(pair.First == 0.0f, pair.Second == 1.0f));
        Assert.True(File.Exists(Path.Combine(_folder.Path, "a", "lit_0m.png")));

        // In pieces: a piece makes no maps, the last call takes what the pieces left.
        CommandLineRun other = Run("c", [.. Where, .. When, "--above-ground", "0,10", "--piece", "1/2"]);
        Assert.Equal((0, string.Empty), (other.ExitCode, other.Output));
        Assert.Equal(0, Run("c", [.. Where, .. When, "--above-ground", "0,10"]).ExitCode);
        foreach (string path in Directory.EnumerateFiles(Path.Combine(_folder.Path, "a"), "*.npy"))
        {
            Assert.Equal(File.ReadAllBytes(path), File.ReadAllBytes(path.Replace("/a/", "/c/", StringComparison.Ordinal)));
        }
    }

    [Fact]
    public void Region_AroundANamedPlace_HasTheMapsOfItsNumbers()
    {
        string[] size =
            ["--size", "2", "--cell", "1000", "--above-ground", "0", "--time-interval", "2026-01-01T00:00:00Z:1d:2026-01-08T00:00:00Z"];
        NamedPlace shackleton = PlaceNames.Find("Shackleton");
        Assert.Equal(0, Run("name", ["--center", "Shackleton", .. size]).ExitCode);
        Assert.Equal(0, Run("numbers", ["--center", FormattableString.Invariant(
            $"{shackleton.Latitude:R},{shackleton.Longitude:R}"), .. size]).ExitCode);

        Assert.Equal(Read("numbers", "lit.npy"), Read("name", "lit.npy"));
        float[] slopes = Read("name", "slope.npy"); // the ground of the place: inside it is never lit
        Assert.Equal((4, true), (slopes.Length, slopes.Max() > 1.0f));
        Assert.Equal(Read("numbers", "slope.npy"), slopes);
    }

    /// <summary>Tables of a point: times of sunrises and sunsets alternate, and the part of the time agrees with them.</summary>
    [Fact]
    public void Points_AMonth_HasSunrisesThatAgreeWithTheLight()
    {
        string list = _folder.Write("sites.csv", "id,name,lat,lon\nA,\"Ridge, high\",-88.3,100\n"u8.ToArray());
        CommandLineRun run = Run("p", ["--points", list, "--above-ground", "10", .. When]);
        Assert.Equal((0, string.Empty), (run.ExitCode, run.Error.Contains("error", StringComparison.Ordinal) ? run.Error : string.Empty));
        string[] rows = File.ReadAllLines(Path.Combine(_folder.Path, "p", "points.csv"));
        Assert.StartsWith("A,\"Ridge, high\",10,", rows[1], StringComparison.Ordinal);
        double lit = double.Parse(rows[1].Split(',')[4], CultureInfo.InvariantCulture);
        string[][] events = [.. File.ReadAllLines(Path.Combine(_folder.Path, "p", "sunrises.csv")).Skip(1).Select(row => row.Split(','))];
        Assert.NotEmpty(events);
        DateTime begin = new(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc);
        DateTime end = begin.AddDays(31.0);
        bool isLit = events[0][2] == "sunset";
        DateTime since = begin;
        double days = 0.0;
        List<(bool IsLit, DateTime Start, DateTime End)> spans = [];
        foreach (string[] row in events)
        {
            Assert.Equal(isLit ? "sunset" : "sunrise", row[2]);
            DateTime time = DateTime.Parse(row[3], CultureInfo.InvariantCulture, DateTimeStyles.AdjustToUniversal);
            days += isLit ? (time - since).TotalDays : 0.0;
            spans.Add((isLit, since, time));
            (isLit, since) = (!isLit, time);
        }

        days += isLit ? (end - since).TotalDays : 0.0;
        spans.Add((isLit, since, end));
        Assert.Equal(days / 31.0, lit, 0.02); // the table counts steps of hours, the rises have their times
        string[] columns = File.ReadLines(Path.Combine(_folder.Path, "p", "points.csv")).First().Split(',');
        string[] cells = rows[1].Replace("\"Ridge, high\"", "Ridge", StringComparison.Ordinal).Split(',');
        foreach ((string name, bool isWithSun) in (ReadOnlySpan<(string, bool)>)[("dark", false), ("light", true)])
        {
            (bool IsLit, DateTime Start, DateTime End) longest = spans.Where(span => span.IsLit == isWithSun)
                .MaxBy(span => span.End - span.Start);
            double hours = double.Parse(Cell($"longest_{name}_h"), CultureInfo.InvariantCulture);
            Assert.Equal((longest.End - longest.Start).TotalHours, hours, 0.001); // h: written with three decimals, rises with seconds
            Assert.Equal(longest.Start, TimeOf(Cell($"longest_{name}_start")));
            Assert.Equal(longest.End, TimeOf(Cell($"longest_{name}_end")));
        }

        int nights = spans.Count(span => !span.IsLit && (span.End - span.Start).TotalHours > 100.0);
        Assert.Equal(nights, int.Parse(Cell("nights"), CultureInfo.InvariantCulture));
        string[] horizon = File.ReadAllLines(Path.Combine(_folder.Path, "p", "horizons.csv"));
        Assert.Equal(1 + 720, horizon.Length);
        Assert.All(horizon.Skip(1), row => Assert.EndsWith(",LDEM_4", row, StringComparison.Ordinal));
        Assert.Contains("<svg", File.ReadAllText(Path.Combine(_folder.Path, "p", "points.html")), StringComparison.Ordinal);

        string Cell(string column) => cells[Array.IndexOf(columns, column)];

        static DateTime TimeOf(string text) => DateTime.Parse(text, CultureInfo.InvariantCulture, DateTimeStyles.AdjustToUniversal);
    }

    /// <summary>Without a place the finest model is the region: its pixels but the outermost, in whose middles its ground ends.</summary>
    [Fact]
    public void Region_NoPlace_IsTheFinestModel()
    {
        Assert.Equal(0, CommandLineRun.Of(
            [
                "ldem", "synthesize", "--projection", "polar-south", "--map-scale", "5000", "--latitude", "89", "--seed", "1",
                "--output-dir", _folder.Path,
            ]).ExitCode);
        string label = Directory.GetFiles(_folder.Path, "*.LBL").Single();
        int side = int.Parse(
            File.ReadLines(label).First(line => line.Trim().StartsWith("LINES ", StringComparison.Ordinal)).Split('=')[1],
            CultureInfo.InvariantCulture);
        CommandLineRun run = Run("f", ["--ldem", label, .. When]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal((side - 2) * (side - 2), Read("f", "lit.npy").Length);
        Assert.All(Read("f", "lit.npy"), value => Assert.InRange(value, 0.0f, 1.0f));

        // A kept file that is damaged is told, and the last run's maps stay.
        string kept = Directory.GetFiles(Path.Combine(_folder.Path, "f", "horizons")).Single();
        byte[] bytes = File.ReadAllBytes(kept);
        bytes.AsSpan(^2).Clear();
        File.WriteAllBytes(kept, bytes);
        CommandLineRun damaged = Run("f", ["--ldem", label, .. When]);
        Assert.Equal((2, string.Empty), (damaged.ExitCode, damaged.Output));
        Assert.Contains("Remove the file; it is made again.", damaged.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1, "--time-interval runs backwards", "--center", "-89,0", "--size", "1", "--time-interval", "61041:1h:61040")]
    [InlineData(1, "Where? The finest model is of the whole body, which is no one map. Give --center", "--time-interval", "61041:1h:61042")]
    [InlineData(1, "Where? Give --center with --size", "--center", "-89,0", "--time-interval", "61041:1h:61042")]
    [InlineData(1, "heights of 0 to 10000", "--center", "-89,0", "--size", "1", "--above-ground", "-2", "--time-interval", "1:1h:2")]
    [InlineData(1, "each once", "--center", "-89,0", "--size", "1", "--above-ground", "2,2.0", "--time-interval", "1:1h:2")]
    [InlineData(1, "leads over a pole", "--center", "30,0", "--size", "4000", "--cell", "20000", "--time-interval", "61041:1h:61042")]
    [InlineData(1, "4000000 cells are the limit", "--center", "-89,0", "--size", "900", "--cell", "1", "--time-interval", "61041:1h:61042")]
    [InlineData(1, "'5/4'; K/N", "--center", "-89,0", "--size", "1", "--piece", "5/4", "--time-interval", "61041:1h:61042")]
    [InlineData(2, ".: is a folder. A list of places in CSV is needed.", "--points", ".", "--time-interval", "61041:1h:61042")]
    [InlineData(3, "2051-01-01", "--center", "-89,0", "--size", "1", "--time-interval", "70000:1d:72000")]
    public void WrongInput_IsOneClearLine(int exitCode, string message, params string[] arguments)
    {
        CommandLineRun run = Run("w", arguments);
        Assert.Equal((exitCode, string.Empty), (run.ExitCode, run.Output));
        string error = Assert.Single(run.Error.Split('\n'), line => line.Contains("error:", StringComparison.Ordinal));
        Assert.Contains(message, error, StringComparison.Ordinal);
    }

    [Fact]
    public void Region_StepOfTwoDays_IsNoted()
    {
        CommandLineRun run = Run("s", ["--center", "-89,0", "--size", "1", "--cell", "500", "--time-interval", "61041:2:61051"]);
        Assert.Equal(0, run.ExitCode);
        Assert.Contains("longer than a day: sunrises and nights in between are not seen", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Any number at once writes the same bytes; an unused column is named, a comma in a name stays in its field.</summary>
    [Fact]
    public void Points_OneAtOnceAndTwo_HaveTheSameTables()
    {
        string list = _folder.Write("sites.csv",
            "id,lat,lon,soil\n\"A,1\",-89.45,222.7,\nB,84,10,\n");
        string[] days = ["--time-interval", "61041:2h:61044"];
        CommandLineRun one = Run("one", ["--points", list, .. days, "--jobs", "1"]);
        Assert.True(one.ExitCode == 0, one.Error);
        Assert.Contains("sites.csv: columns that are not used: soil.", one.Error, StringComparison.Ordinal);
        Assert.Equal(0, Run("two", ["--points", list, .. days, "--jobs", "2"]).ExitCode);
        Assert.Equal(4, Directory.GetFiles(Path.Combine(_folder.Path, "one")).Length);
        foreach (string path in Directory.EnumerateFiles(Path.Combine(_folder.Path, "one")))
        {
            Assert.Equal(File.ReadAllBytes(path), File.ReadAllBytes(path.Replace("/one/", "/two/", StringComparison.Ordinal)));
        }

        string[] rows = File.ReadAllLines(Path.Combine(_folder.Path, "one", "points.csv"));
        Assert.Equal(1 + 2, rows.Length);
        Assert.StartsWith("\"A,1\",,0,", rows[1], StringComparison.Ordinal);
        Assert.StartsWith("B,,0,", rows[^1], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("lat,lon,height\n-89,0,\n-88,0,2\n", "the point '2' has a height of its own")]
    [InlineData("id,x,y,z\nA,0,0,-1737400\n", "the point 'A' has a height of its own")]
    public void Points_WithHeights_AreRefused(string text, string message)
    {
        string list = _folder.Write("high.csv", text);
        CommandLineRun run = Run("h", ["--points", list, .. When]);
        Assert.Equal((2, string.Empty), (run.ExitCode, run.Output));
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Contains("--above-ground gives heights over it", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Points_TooMany_AreRefused()
    {
        string list = _folder.Write("many.csv", "lat,lon\n" + string.Concat(Enumerable.Repeat("-89,0\n", 1_000_000)));
        CommandLineRun run = Run("m", ["--points", list, .. When]);
        Assert.Equal((2, string.Empty), (run.ExitCode, run.Output));
        Assert.Contains("more than 1000 landmarks or points. Leave some out.", run.Error, StringComparison.Ordinal);
    }

    /// <summary>Mercury at perihelion, 0.3075 au, in December 2020: 1361 W/m2 over its square.</summary>
    [Fact]
    public void Region_OfMercury_HasItsSun()
    {
        Assert.Equal(0, CommandLineRun.Of(
            ["ldem", "synthesize", "--body", "mercury", "--res", "1", "--seed", "1", "--output-dir", _folder.Path]).ExitCode);
        string label = Directory.GetFiles(_folder.Path, "*.LBL").Single();
        string[] place = ["--center", "85,30", "--size", "60", "--cell", "20000", "--ldem", label];
        string[] months = ["--time-interval", "2020-11-01T00:00:00Z:1d:2021-02-01T00:00:00Z"];
        CommandLineRun run = Run("b", [.. place, .. months, "--body", "mercury"]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.All(Read("b", "flux_tracking_max.npy"), flux => Assert.Equal(1361.0 / (0.3075 * 0.3075), flux, 20.0));
        Assert.InRange(Read("b", "lit.npy").Average(), 0.2f, 0.7f);
        CommandLineRun moon = Run("c", ["--center", "85,30", "--size", "60", "--cell", "20000", .. months, "--body", "mercury"]);
        Assert.Equal((1, string.Empty), (moon.ExitCode, moon.Output));
        Assert.Contains("--ldem", moon.Error, StringComparison.Ordinal);
    }

    private CommandLineRun Run(string folder, string[] arguments) => CommandLineRun.Of(
        ["illumination", .. arguments, "--ephemeris", "builtin", "--output-dir", Path.Combine(_folder.Path, folder), "--batch"]);

    private float[] Read(string folder, string name)
    {
        byte[] bytes = File.ReadAllBytes(Path.Combine(_folder.Path, folder, name));
        int head = 10 + BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(8));
        return MemoryMarshal.Cast<byte, float>(bytes.AsSpan(head)).ToArray();
    }
}
