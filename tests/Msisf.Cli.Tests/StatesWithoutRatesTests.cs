using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// <c>msis states</c> where it is not known how the camera moves: the states are written without, and no shutter is spoken of.
/// </summary>
public sealed class StatesWithoutRatesTests : IDisposable
{
    /// <summary>Two minutes of a trajectory, and one state alone eight minutes later.</summary>
    private const string Oem =
        "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2024-01-01T00:00:00\nORIGINATOR = X\n"
            + "META_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = EME2000\nTIME_SYSTEM = UTC\n"
            + "START_TIME = 2024-01-19T12:00:00\nSTOP_TIME = 2024-01-19T12:02:00\nMETA_STOP\n"
            + "2024-01-19T12:00:00 1900 0 0 0 1.6 0\n2024-01-19T12:01:00 1897.59 95.96 0 -0.0802 1.598 0\n"
            + "2024-01-19T12:02:00 1890.37 191.67 0 -0.1602 1.5919 0\n"
            + "META_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = EME2000\nTIME_SYSTEM = UTC\n"
            + "START_TIME = 2024-01-19T12:10:00\nSTOP_TIME = 2024-01-19T12:10:00\nMETA_STOP\n"
            + "2024-01-19T12:10:00 1700 900 0 -0.8 1.4 0\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The file states the velocity, and the camera looks at the Moon: so its motion is known at each state.</summary>
    [Theory]
    [InlineData("2024-01-19T12:10:00Z")]
    [InlineData("2024-01-19T12:02:00Z")]
    [InlineData("2024-01-19T12:01:00Z")]
    public void States_OfOneTimeAlone_HaveTheMotionThatTheFileStates(string time)
    {
        CommandLineRun run = Run("--oem", _folder.Write("p.oem", Oem), "--time", time);

        Assert.Equal(0, run.ExitCode);
        string[] lines = run.Output.TrimEnd().Split('\n');
        Assert.EndsWith(",vx,vy,vz,wx,wy,wz", lines[^2], StringComparison.Ordinal);
        Assert.Equal(14, lines[^1].Split(',').Length);
    }

    /// <summary>A table of places alone, with one state: nobody knows how the camera moves.</summary>
    [Fact]
    public void States_OfOneTimeAlone_WithoutVelocity_HaveNoMotion()
    {
        string stk = _folder.Write(
            "one.e",
            "stk.v.11.0\nBEGIN Ephemeris\nNumberOfEphemerisPoints 1\nScenarioEpoch 19 Jan 2024 12:10:00.000\nCentralBody Moon\n"
                + "CoordinateSystem J2000\nDistanceUnit Kilometers\nEphemerisTimePos\n0 1700 900 0\nEND Ephemeris\n");

        CommandLineRun run = Run("--oem", stk, "--time", "2024-01-19T12:10:00Z");

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.DoesNotContain("shutter", run.Error, StringComparison.Ordinal);
        string[] lines = run.Output.TrimEnd().Split('\n');
        Assert.EndsWith(",qx,qy,qz,qw", lines[^2], StringComparison.Ordinal);
        Assert.Equal(8, lines[^1].Split(',').Length);
    }

    /// <summary>The given rate is stated, however fast: neighbouring attitudes would not tell 200 rad/s.</summary>
    [Fact]
    public void States_OfACameraThatTurnsFast_HaveTheGivenRate()
    {
        CommandLineRun run = Run(
            "--kepler-set", "{1.9E6,0.05,0.7,1.1,0.9,2.0}", "--epoch", "55289", "--time", "55289", "--attitude", "{0,0,0,1}",
            "--attitude-transition", "{0,0,200}");

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(["0", "0", "200"], run.Output.TrimEnd().Split('\n')[^1].Split(',')[^3..]);
    }

    /// <summary>A double of MJD holds 0.6 microseconds, moments are exact: steps of 0.1 microseconds are all there.</summary>
    [Fact]
    public void States_OfStepsShorterThanADateCanTell_AreAllThere()
    {
        string oem = _folder.Write(
            "short.oem",
            Oem[..Oem.IndexOf("START_TIME", StringComparison.Ordinal)]
                + "START_TIME = 2024-01-19T12:00:00\nSTOP_TIME = 2024-01-19T12:00:00.000010\nMETA_STOP\n"
                + "2024-01-19T12:00:00.000000 1900 0 0 0 1.6 0\n2024-01-19T12:00:00.000010 1900 0.000016 0 0 1.6 0\n");

        CommandLineRun run = Run("--oem", oem, "--every", "1e-7");

        Assert.Equal(0, run.ExitCode);
        Assert.InRange(run.Output.TrimEnd().Split('\n').Count(line => char.IsAsciiDigit(line[0])), 100, 101);
    }

    private static CommandLineRun Run(params string[] words) =>
        CommandLineRun.Of(["states", "--format", "csv", "--res", "7", "--ephemeris", "builtin", .. words]);
}
