using System.Globalization;
using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Integration.Tests.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Orbit;

/// <summary>One orbit over the leap second at the end of 2016, asked for the same moments in every way that a time can be given.</summary>
public sealed class WaysToGiveATimeTests : IDisposable
{
    /// <summary>m: 1e-9 s of 1.7 km/s, and the rounding of positions that are printed or summed.</summary>
    private const double Position = 2e-6;

    /// <summary>m: a kernel's epochs are doubles of TDB, whose steps are 6e-8 s.</summary>
    private const double PositionOfKernel = 1.1e-4;

    private const string Epoch = "2016-12-31T22:00:00Z";
    private const string Orbit = "{1.838E6,0.01,0.7,1.1,0.9,2.0}";

    private static readonly KeplerOrbit Kepler = new(new KeplerElements(1.838e6, 0.01, 0.7, 1.1, 0.9, 2.0));

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The moment, and its SI seconds since the epoch by hand: two hours are 7200 s, and the leap second is the 7201st.</summary>
    [Theory]
    [InlineData("2016-12-31T23:59:00.5Z", 7140.5)]
    [InlineData("2016-12-31T23:59:60.25Z", 7200.25)]
    [InlineData("2017-01-01T00:00:00Z", 7201.0)]
    [InlineData("2017-01-01T00:10:00.123456789Z", 7801.123456789)]
    public void Positions_EveryWay_AreThatOfTheOrbit(string time, double seconds)
    {
        Vector3D expected = Kepler.PositionAt(seconds);
        string[] orbit = ["--kepler-set", Orbit, "--epoch", Epoch, "--orbit-frame", "j2000"];

        AssertNear(expected, States([.. orbit, "--time", time]));
        AssertNear(expected, States([.. orbit, "--times", $"{{{time}}}"]));
        if (!time.Contains(":60", StringComparison.Ordinal))
        {
            AssertNear(expected, States([.. orbit, "--time-interval", $"[{time}:1s:{time}]"]));
        }

        // The second of two lines; the image has the time of the first.
        string period = Text(seconds - 7080.0);
        string camera = _folder.Write(
            "line.yaml", $"width: 16\nheight: 1\nfocal-length-px: 300\nscan:\n  kind: line-scan\n  period: {period}\n");
        AssertNear(
            expected,
            States([.. orbit, "--time", "2016-12-31T23:58:00Z", "--camera", camera, "--lines", "2", "--renderer", "native"]));

        string oem = WriteOem();
        foreach (string file in (string[])[oem, WriteStk(), WriteHorizons()])
        {
            AssertNear(expected, States(["--oem", file, "--look-at", "nadir", "--time", time]));
        }

        AssertNear(expected, States(["--trajectory", WriteSeconds(), "--time", time]));

        string kernels = _folder["kernels"];
        Succeed(["states", "--format", "spice", "--to", kernels, "--oem", oem, "--look-at", "nadir", "--every", "10"]);
        string spk = Path.Combine(kernels, "states.bsp");
        foreach (string engine in (string[])["builtin", "cspice"])
        {
            if (engine == "builtin" || TestParts.CSpiceLibrary is not null)
            {
                Assert.InRange(
                    (States(["--spk", spk, "--spacecraft", "-999", "--look-at", "nadir", "--time", time, "--ephemeris", engine])
                        - expected).Length,
                    0.0, PositionOfKernel);
            }
        }
    }

    /// <summary>A batch file's column seconds counts SI seconds: the second of its two states has the moment's name.</summary>
    [Theory]
    [InlineData("2016-12-31T23:59:60.250000000", "7200.25")]
    [InlineData("2017-01-01T00:10:00.123456789", "7801.123456789")]
    public void Seconds_OfABatchFile_AreSiSecondsFromTheEpoch(string time, string seconds)
    {
        string file = _folder.Write(
            "seconds.csv",
            $"seconds,x,y,z,qx,qy,qz,qw\n0,2e6,0,0,0,0,0,1\n{seconds},2e6,1e3,0,0,0,0,1\n");

        Succeed(["states", "--format", "oem", "--to", _folder["out"], "--batch-file", file, "--epoch", Epoch]);

        Assert.StartsWith(time, LastLine(), StringComparison.Ordinal);
    }

    private static void AssertNear(Vector3D expected, Vector3D found) => Assert.InRange((found - expected).Length, 0.0, Position);

    /// <summary>Half an hour about the leap second, in TAI, which has none; between states 10 s apart Hermite is good to 1e-7 m.</summary>
    private string WriteOem()
    {
        List<string> lines =
        [
            "CCSDS_OEM_VERS = 2.0", "CREATION_DATE = 2024-01-01T00:00:00", "ORIGINATOR = MSISF", "META_START", "OBJECT_NAME = X",
            "OBJECT_ID = 2024-001A", "CENTER_NAME = MOON", "REF_FRAME = ICRF", "TIME_SYSTEM = TAI",
            "START_TIME = 2016-12-31T23:45:36", "STOP_TIME = 2017-01-01T00:15:36", "INTERPOLATION = HERMITE",
            "INTERPOLATION_DEGREE = 7", "META_STOP",
        ];
        for (int second = 0; second <= 1800; second += 10)
        {
            StateVector state = Kepler.StateAt(6300.0 + second); // TAI - UTC is 36 s at the epoch
            DateTime tai = new DateTime(2016, 12, 31, 23, 45, 36).AddSeconds(second);
            lines.Add(FormattableString.Invariant($"{tai:yyyy-MM-dd'T'HH:mm:ss} ")
                + string.Join(' ', Numbers(state).Select(number => Text(number / 1000.0))));
        }

        return _folder.Write("orbit.oem", string.Join('\n', lines) + "\n");
    }

    /// <summary>The same half hour in seconds since an epoch in UTC.</summary>
    private string WriteStk()
    {
        IEnumerable<string> lines = Enumerable.Range(0, 181).Select(index =>
        {
            double seconds = 6300.0 + (10.0 * index);
            return string.Join(' ', ((double[])[seconds, .. Numbers(Kepler.StateAt(seconds))]).Select(Text));
        });
        return _folder.Write(
            "orbit.e",
            "stk.v.12.0\nBEGIN Ephemeris\nNumberOfEphemerisPoints 181\nScenarioEpoch 31 Dec 2016 22:00:00.000000\n"
                + "InterpolationMethod Hermite\nInterpolationSamplesM1 7\nCentralBody Moon\nCoordinateSystem J2000\n"
                + $"EphemerisTimePosVel\n{string.Join('\n', lines)}\nEND Ephemeris\n");
    }

    /// <summary>The same half hour at whole seconds of TDB, about 69 s after UTC.</summary>
    private string WriteHorizons()
    {
        const string Rule = "*******************************************************************************\n";
        DateTime j2000 = new(2000, 1, 1, 12, 0, 0);
        double epochTai = (new DateTime(2016, 12, 31, 22, 0, 36) - j2000).TotalSeconds;
        IEnumerable<string> lines = Enumerable.Range(0, 181).Select(index =>
        {
            DateTime tdb = new DateTime(2016, 12, 31, 23, 46, 0).AddSeconds(10 * index);
            double seconds = (tdb - j2000).TotalSeconds;

            // By hand: naif0012.tls has K = 1.657e-3 s, EB = 1.671e-2, M = 6.239996 + 1.99096871e-7 t.
            double mean = 6.239996 + (1.99096871e-7 * seconds);
            double tdbMinusTt = 1.657e-3 * Math.Sin(mean + (1.671e-2 * Math.Sin(mean)));
            double[] km = [.. Numbers(Kepler.StateAt(seconds - epochTai - 32.184 - tdbMinusTt)).Select(number => number / 1000.0)];
            return FormattableString.Invariant(
                $"{2451545.0 + (seconds / 86400.0):F9}, A.D. {tdb:yyyy-MMM-dd HH:mm:ss}.0000, {string.Join(", ", km.Select(Text))},");
        });
        return _folder.Write(
            "horizons.txt",
            $"{Rule}Target body name: X (-155)\nCenter body name: Moon (301)\nCenter-site name: BODY CENTER\n"
                + "Output units    : KM-S\nOutput type     : GEOMETRIC cartesian states\nOutput format   : 2 (position and velocity)\n"
                + $"Reference frame : ICRF\n{Rule}"
                + "JDTDB, Calendar Date (TDB), X, Y, Z, VX, VY, VZ,\n"
                + $"$$SOE\n{string.Join('\n', lines)}\n$$EOE\n{Rule}");
    }

    /// <summary>The same half hour as samples in seconds since the epoch.</summary>
    private string WriteSeconds()
    {
        IEnumerable<string> lines = Enumerable.Range(0, 181).Select(index =>
        {
            double seconds = 6300.0 + (10.0 * index);
            return string.Join(',', ((double[])[seconds, .. Numbers(Kepler.StateAt(seconds))[..3], 0.0, 0.0, 0.0, 1.0]).Select(Text));
        });
        return _folder.Write(
            "samples.csv", $"# msis: frame=j2000 epoch={Epoch}\nseconds,x,y,z,qx,qy,qz,qw\n{string.Join('\n', lines)}\n");
    }

    private static double[] Numbers(StateVector state) =>
        [state.Position.X, state.Position.Y, state.Position.Z, state.Velocity.X, state.Velocity.Y, state.Velocity.Z];

    private static string Text(double number) => number.ToString("R", CultureInfo.InvariantCulture);

    private string LastLine() => File.ReadLines(_folder["out/states.oem"]).Last(text => text.Length > 20 && char.IsDigit(text[0]));

    /// <summary>The position of the last state that <c>msis states</c> writes, J2000.</summary>
    private Vector3D States(string[] run)
    {
        Succeed(["states", "--format", "oem", "--to", _folder["out"], .. run]);
        double[] km = [.. LastLine().Split(' ', StringSplitOptions.RemoveEmptyEntries)[1..4].Select(
            word => double.Parse(word, CultureInfo.InvariantCulture))];
        return 1000.0 * new Vector3D(km[0], km[1], km[2]);
    }

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
