using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

public sealed class PlacesCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Places_Name_HasItsLine()
    {
        string[] lines = Lines("places", "apollo", "11");

        Assert.Equal(2, lines.Length);
        Assert.Matches("^Apollo 11 +landing site +0\\.67416 +23\\.47314 +-$", lines[1]);
    }

    [Fact]
    public void Places_NearAName_HasTheNearestFirst()
    {
        using JsonDocument rows = JsonDocument.Parse(string.Join('\n', Lines("places", "--near", "Tycho", "--format", "json")));
        double[] distances = [.. rows.RootElement.EnumerateArray().Select(row => row.GetProperty("distance").GetDouble())];

        Assert.Equal("Tycho", rows.RootElement[0].GetProperty("name").GetString());
        Assert.Equal(20, distances.Length);
        Assert.Equal(distances.Order(), distances);
    }

    [Fact]
    public void Places_AllOfThem_AreMoreThan9000() => Assert.True(Lines("places").Length > 9000);

    [Theory]
    [InlineData("places --near nadir", "--near: 'nadir' is not a place; LAT,LON or NAME is needed.")]
    [InlineData("places Tycho --near 1,2", "--near and NAME exclude each other. Leave one out.")]
    [InlineData("places Tyco", "did you mean Tycho?")]
    [InlineData("--position Tycho --time 55289 --dry-run", "'Tycho' has 1 part; LAT,LON,HEIGHT or NAME,HEIGHT is needed")]
    [InlineData("--position 1,2,3e5 --look-at nadr --time 55289 --dry-run", "nadir, sun or horizon:AZIMUTH is needed.")]
    [InlineData("--position Tycho,100 --body mars --time 55289 --dry-run", "the named places are the Moon's, but Mars is drawn.")]
    [InlineData(
        "--position 1,2,3e5 --look-at Sundman --body mars --time 55289 --dry-run", "the named places are the Moon's, but Mars is drawn.")]
    [InlineData(
        "illumination --body mars --center Shackleton --size 1 --time-interval [55289:0.1:55290]",
        "--center: 'Shackleton' is a name, and the named places are the Moon's, but Mars is drawn.")]
    [InlineData(
        "illumination --center Tyco --size 1 --time-interval [55289:0.1:55290]", "--center: 'Tyco' is not a named place of the Moon")]
    public void Run_WrongPlace_SaysWhatToDo(string run, string expected)
    {
        CommandLineRun done = CommandLineRun.Of(run.Split(' '));

        Assert.InRange(done.ExitCode, 1, 2);
        Assert.Contains(expected, done.Error, StringComparison.Ordinal);
    }

    /// <summary>The same states by names and by the numbers that msis places prints, from the command line and from a file.</summary>
    [RequiresFact(Part.Ldem4)]
    public void States_ByNameAndByNumbers_AreTheSame()
    {
        string[] time = ["--time", "2010-04-24T00:00:00Z"];
        string[] row = Lines("places", "campanus")[1].Split("  ", StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        string campanus = $"{row[2]},{row[3]},terrain+10";
        string[] numbers = States(["--position", "-43.2958,348.785,80000", "--look-at", campanus, .. time]);

        Assert.Equal(numbers, States(["--position", "Tycho,80000", "--look-at", "campanus,terrain+10", .. time]));
        string batch = _folder.Write(
            "places.csv", "time,place,height,look_at,look_height\n2010-04-24T00:00:00Z,Tycho,80000,CAMPANUS,terrain+10\n");
        Assert.Equal(numbers, States(["--batch-file", batch]));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("time,place,look_at\n55310,Tycho,Tycho\n", "column height is missing: place, height go together.")]
    [InlineData("time,place,height,look_at,off_nadir\n55310,Tycho,8e4,Tycho,3\n", "look_at and off_nadir both say where the camera looks.")]
    [InlineData("time,place,lat,lon,height\n55310,Tycho,1,2,8e4\n", "Name one of them.")]
    [InlineData("time,place,height\n55310,Tyco,8e4\n", "'Tyco' is not a named place of the Moon: did you mean Tycho?")]
    public void Run_WrongColumnOfPlaces_IsNamed(string content, string expected)
    {
        CommandLineRun done = CommandLineRun.Of(["--batch-file", _folder.Write("wrong.csv", content), "--dry-run"]);

        Assert.NotEqual(0, done.ExitCode);
        Assert.Contains(expected, done.Error, StringComparison.Ordinal);
    }

    private static string[] Lines(params string[] words)
    {
        CommandLineRun done = CommandLineRun.Of(words);
        Assert.True(done.ExitCode == 0, done.Error);
        return done.Output.TrimEnd().Split('\n');
    }

    private static string[] States(string[] options) => Lines(["states", "--format", "csv", .. options]);
}
