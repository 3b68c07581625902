using System.Globalization;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Times about the leap second at the end of 2016. A spacecraft flies 1 km in each SI second: its place tells the time.</summary>
public sealed class LeapSecondTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Every_OverTheLeapSecond_CountsIt()
    {
        (string[] times, double[] km, string notes) = States("--every", "1");

        Assert.Equal(121, times.Length);
        Assert.Equal("2016-12-31T23:59:00.000000000", times[0]);
        Assert.Equal(
            ["2016-12-31T23:59:59.000000000", "2016-12-31T23:59:60.000000000", "2017-01-01T00:00:00.000000000"], times[59..62]);
        Assert.All(km.Select((x, second) => x - (3000.0 + second)), error => Assert.Equal(0.0, error, 5e-9));
        Assert.Contains(
            "--every counts SI seconds: there is a leap second between 2016-12-31T23:59:00Z and 2017-01-01T00:00:59Z", notes,
            StringComparison.Ordinal);
    }

    [Fact]
    public void TimeInterval_OverTheLeapSecond_CountsTheClock()
    {
        (string[] times, double[] km, string notes) = States("--time-interval", "[2016-12-31T23:59:50Z:10s:2017-01-01T00:00:10Z]");

        Assert.Equal(["2016-12-31T23:59:50.000000000", "2017-01-01T00:00:00.000000000", "2017-01-01T00:00:10.000000000"], times);
        Assert.Equal([50.0, 61.0, 71.0], km.Select(x => Math.Round(x - 3000.0, 9)));
        Assert.Contains("--time-interval counts days of 86,400 s on the clock", notes, StringComparison.Ordinal);
    }

    [Fact]
    public void Time_InTheLeapSecond_IsItsOwnPlace()
    {
        (string[] times, double[] km, string notes) = States("--time", "2016-12-31T23:59:60.5Z");

        Assert.Equal((("2016-12-31T23:59:60.500000000"), 3060.5), (Assert.Single(times), Math.Round(Assert.Single(km), 9)));
        Assert.DoesNotContain("leap second", notes, StringComparison.Ordinal);
    }

    /// <summary>An MJD can't name it: the last number of the day stands for it.</summary>
    [Fact]
    public void Batch_InTheLeapSecond_HasTheLastMjdOfTheDay()
    {
        CommandLineRun run = CommandLineRun.Of(
            ["states", "--format", "batch", "--to", _folder["b.tab"], "--oem", WriteOem(), "--time", "2016-12-31T23:59:60.5Z"]);
        Assert.True(run.ExitCode == 0, run.Error);

        string line = File.ReadLines(_folder["b.tab"]).Last();
        Assert.Equal(Math.BitDecrement(57754.0), double.Parse(line.Split(' ')[0], CultureInfo.InvariantCulture));
    }

    [Theory]
    [InlineData("2017-12-31T23:59:60Z", 2, "there was no leap second then")]
    [InlineData("2016-12-31T12:59:60Z", 1, "seconds 00 to 59, but for a leap second, 23:59:60 UTC")]
    public void Time_LeapSecondThatWasNot_IsRefused(string time, int exitCode, string reason)
    {
        CommandLineRun run = CommandLineRun.Of(["states", "--to", _folder["x"], "--oem", WriteOem(), "--time", time]);

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(reason, run.Error, StringComparison.Ordinal);
    }

    private (string[] Times, double[] Km, string Notes) States(params string[] times)
    {
        CommandLineRun run = CommandLineRun.Of(["states", "--format", "oem", "--to", _folder["out"], "--oem", WriteOem(), .. times]);
        Assert.True(run.ExitCode == 0, run.Error);
        string[][] lines =
            [.. File.ReadLines(_folder["out/states.oem"]).Where(line => line.Length > 20 && char.IsDigit(line[0]))
                .Select(line => line.Split(' '))];
        return (
            [.. lines.Select(words => words[0])], [.. lines.Select(words => double.Parse(words[1], CultureInfo.InvariantCulture))],
            run.Error);
    }

    /// <summary>Two minutes and the leap second in TAI, 36 s before UTC's 23:59:00 and 37 s after its 00:00:59.</summary>
    private string WriteOem()
    {
        StringBuilder text = new();
        text.Append("CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2024-01-01T00:00:00\nORIGINATOR = MSISF\nMETA_START\nOBJECT_NAME = X\n")
            .Append("OBJECT_ID = 2024-001A\nCENTER_NAME = MOON\nREF_FRAME = ICRF\nTIME_SYSTEM = TAI\n")
            .Append("START_TIME = 2016-12-31T23:59:36\nSTOP_TIME = 2017-01-01T00:01:36\nINTERPOLATION = HERMITE\n")
            .Append("INTERPOLATION_DEGREE = 7\nMETA_STOP\n");
        for (int second = 0; second <= 120; second += 10)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"{new DateTime(2016, 12, 31, 23, 59, 36).AddSeconds(second):yyyy-MM-dd'T'HH:mm:ss} {3000 + second} 0 0 1 0 0\n");
        }

        return _folder.Write("straight.oem", text.ToString());
    }
}
