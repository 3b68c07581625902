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

        string oem = WriteOem();
        AssertNear(expected, States(["--oem", oem, "--look-at", "nadir", "--time", time]));

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

    /// <summary>The scan's lines, and a batch file's seconds, count SI seconds.</summary>
    [Fact]
    public void ScanAndSeconds_OverTheLeapSecond_AreThoseOfTheOrbit()
    {
        using OpenedEphemeris engine = Engines.BuiltIn();
        TimeScale scale = engine.Engine.TimeScale;
        Instant epoch = scale.InstantOf(CalendarTime.OfMjd(57753.0) + Duration.OfSeconds(79_200));
        OrbitPropagator propagator = new(Kepler.Elements, epoch, OrbitFrame.J2000, engine.Engine);
        for (double second = 7199.0; second < 7203.0; second += 0.125)
        {
            Instant time = epoch.After(second);
            Vector3D found = engine.Engine.BodyFromJ2000(time.Tdb).Transposed * propagator.PositionBodyFixed(time);
            Assert.InRange((found - Kepler.PositionAt(second)).Length, 0.0, Position);
        }
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
            double[] numbers =
                [state.Position.X, state.Position.Y, state.Position.Z, state.Velocity.X, state.Velocity.Y, state.Velocity.Z];
            lines.Add(FormattableString.Invariant($"{tai:yyyy-MM-dd'T'HH:mm:ss} ")
                + string.Join(' ', numbers.Select(number => (number / 1000.0).ToString("R", CultureInfo.InvariantCulture))));
        }

        return _folder.Write("orbit.oem", string.Join('\n', lines) + "\n");
    }

    /// <summary>The position of the only state that <c>msis states</c> writes, J2000.</summary>
    private Vector3D States(string[] run)
    {
        Succeed(["states", "--format", "oem", "--to", _folder["out"], .. run]);
        string line = File.ReadLines(_folder["out/states.oem"]).Last(text => text.Length > 20 && char.IsDigit(text[0]));
        double[] km = [.. line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[1..4].Select(
            word => double.Parse(word, CultureInfo.InvariantCulture))];
        return 1000.0 * new Vector3D(km[0], km[1], km[2]);
    }

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
