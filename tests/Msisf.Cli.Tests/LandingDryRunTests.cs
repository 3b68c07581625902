using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// <c>--dry-run</c> of a landing says how long its target stays lit: the same as the table of sunrises of <c>msis illumination</c>, whose
/// rays are the tracer's.
/// </summary>
public sealed partial class LandingDryRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(61041.0, "stays lit for", "sunset")]
    [InlineData(61050.0, "lies in shadow", "sunrise")]
    public void DryRun_Landing_SaysWhenTheLightChanges(double start, string words, string change)
    {
        CommandLineRun run = DryRun(start, 30_000.0, 9_000.0, 100.0);
        Assert.True(run.ExitCode == 0, run.Error);
        string note = Assert.Single(run.Error.Split('\n'), line => line.Contains("The target below", StringComparison.Ordinal));
        Assert.Contains(words, note, StringComparison.Ordinal);
        string list = _folder.Write("sites.csv", "lat,lon\n-70.3,100\n");
        CommandLineRun table = CommandLineRun.Of([
            "illumination", "--points", list, "--ephemeris", "builtin", "--batch", "--output-dir", _folder["p"], "--time-interval",
            string.Create(CultureInfo.InvariantCulture, $"{start + 0.02:R}:1h:{start + 40.0:R}")]);
        Assert.True(table.ExitCode == 0, table.Error);
        string[] first = File.ReadLines(_folder["p/sunrises.csv"]).Skip(1).First().Split(',');
        Assert.Equal(change, first[^2]);
        DateTime expected = DateTime.Parse(first[^1], CultureInfo.InvariantCulture);
        DateTime told = DateTime.Parse(Time().Match(note).Value, CultureInfo.InvariantCulture);
        Assert.InRange((told - expected).TotalSeconds, -1.0, 1.0);
        double hours = double.Parse(Hours().Match(note).Groups[1].Value, CultureInfo.InvariantCulture);
        // days: hours are written with one decimal
        Assert.Equal((told - DateTime.UnixEpoch).TotalDays + 40587.0 - (start + 0.02), hours / 24.0, 0.003);
    }

    [Theory]
    [InlineData(30_000.0, 20_000.0, 10_000.0)]
    [InlineData(100.0, 9_000.0, 30_000.0)]
    public void DryRun_NoLanding_SaysNothing(params double[] heights) =>
        Assert.DoesNotContain("target", DryRun(61041.0, heights).Error, StringComparison.Ordinal);

    [GeneratedRegex(@"20\d\d-[0-9T:.-]+Z")]
    private static partial Regex Time();

    [GeneratedRegex(@"([0-9.]+) h\b")]
    private static partial Regex Hours();

    /// <summary>Frames straight above one place, at heights over the reference sphere, m; the ground there is 0.6 km below it.</summary>
    private CommandLineRun DryRun(double start, params double[] heights)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(-70.3));
        (double east, double near) = Math.SinCos(double.DegreesToRadians(100.0));
        IEnumerable<string> lines = heights.Select((height, i) => string.Create(CultureInfo.InvariantCulture,
            $"{start + (0.01 * i):R} {Place(height, cosine * near)} {Place(height, cosine * east)} {Place(height, sine)} 0 0 0 1"));
        string file = _folder.Write("landing.tab", string.Join('\n', lines) + "\n");
        return CommandLineRun.Of(["--batch-file", file, "--batch-frame", "moon-me", "--dry-run", "--ephemeris", "builtin"]);

        static string Place(double height, double axis) => ((1_737_400.0 + height) * axis).ToString("R", CultureInfo.InvariantCulture);
    }
}
