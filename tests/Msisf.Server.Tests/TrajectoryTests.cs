using System.Globalization;
using System.Net;
using System.Text.Json;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>A trajectory as a request's "states": a list of states, or an OEM of <c>--folders</c>.</summary>
public sealed class TrajectoryTests : IDisposable
{
    private const double Start = 60328.5; // 2024-01-19T12:00:00Z
    private const double Radius = 2.0e6; // m
    private const double Rate = 8e-4; // rad/s
    private const double Day = 86400.0;
    private const double SameMoment = 2e-6; // m: 1e-9 s of 1.7 km/s, and the rounding of positions that are printed or summed
    private const string Small = "\"width\": 24, \"height\": 18, \"fov\": 30, \"albedo-map\": \"none\"";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>A circle about the Moon's axis, sampled each minute in a list of MOON_ME, is met between the samples.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task List_BetweenItsStates_IsOnTheCircle()
    {
        using RunningServer server = await RunningServer.StartAsync();
        double time = Start + (217.0 / Day);

        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", $"{{\"states\": {Rows()}, \"time\": {Text(time)}, {Small}}}", "application/json");

        JsonElement position = (await RunningServer.JsonOf(answer)).GetProperty("GeneralInformation").GetProperty("CameraPosition")
            .GetProperty("Vector3D");
        (double sin, double cos) = Math.SinCos(Rate * (time - Start) * Day);
        Assert.Equal(Radius * cos, position.GetProperty("x").GetDouble(), 2e-3); // an MJD is rounded to 0.6 microseconds: 1 mm
        Assert.Equal(Radius * sin, position.GetProperty("y").GetDouble(), 2e-3);
        Assert.Equal(0.0, position.GetProperty("z").GetDouble(), 1e-6);
        await server.DisposeAsync();
    }

    /// <summary>The same states as a list along J2000, and as an OEM by its name, are drawn as msis draws the OEM.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task ListAndName_AreDrawnAsMsisDrawsTheOem()
    {
        string oem = _folder.Write("orbit.oem", Oem());
        string time = "\"time\": \"2024-01-19T12:03:37Z\"";
        CommandLineRun run = CommandLineRun.Of(
        [
            "--oem", oem, "--time", "2024-01-19T12:03:37Z", "--off-nadir", "5,40", "--renderer", "native", "--width", "24", "--height",
            "18", "--fov", "30", "--albedo-map", "none", "--batch", "--output-dir", _folder["out"],
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        byte[] expected = await File.ReadAllBytesAsync(Directory.GetFiles(_folder["out"], "*.png").Single());
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, oem));

        Assert.Equal(expected, await server.RenderAsync($"\"states\": \"orbit.oem\", {time}, \"off-nadir\": \"5,40\", {Small}"));
        Assert.Equal(
            expected,
            await server.RenderAsync(
                $"\"states\": {RowsOfCalendarTimes()}, \"orbit-frame\": \"j2000\", {time}, \"off-nadir\": \"5,40\", {Small}"));
        File.Delete(oem); // it has been read
        Assert.NotEqual(expected, await server.RenderAsync($"\"states\": \"orbit.oem\", {time}, {Small}"));
        await server.DisposeAsync();
    }

    /// <summary>A request's time means the moment that the command line takes it for, in the leap second at the end of 2016 too.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("2016-12-31T23:59:00.5Z")]
    [InlineData("2016-12-31T23:59:60.25Z")]
    [InlineData("2017-01-01T00:04:00.123456789Z")]
    public async Task ListAndName_OverALeapSecond_AreAtTheMomentOfTheOrbit(string time)
    {
        string[] orbit =
            ["states", "--kepler-set", "{1.838E6,0.01,0.7,1.1,0.9,2.0}", "--epoch", "2016-12-31T22:00:00Z", "--orbit-frame", "j2000"];
        string[] samples = ["--format", "oem", "--to", _folder["oem"], "--time-interval", "[2016-12-31T23:55Z:10s:2017-01-01T00:05Z]"];
        CommandLineRun expected = CommandLineRun.Of([.. orbit, "--format", "csv", "--time", time]);
        Assert.True(expected.ExitCode == 0, expected.Error);
        double[] place = [.. expected.Output.TrimEnd().Split('\n')[^1].Split(',')[1..4].Select(Number)];
        Assert.Equal(0, CommandLineRun.Of([.. orbit, .. samples]).ExitCode);
        IEnumerable<string> rows = File.ReadLines(_folder["oem/states.oem"])
            .Where(line => line.Length > 20 && char.IsAsciiDigit(line[0]))
            .Select(line => line.Split(' '))
            .Select(words => $"[\"{words[0]}Z\", {string.Join(", ", words[1..7].Select(word => Text(1000.0 * Number(word))))}]");
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, _folder["oem/states.oem"]));

        foreach (string states in (string[])
            ["\"states.oem\"", $"[{string.Join(", ", rows)}], \"orbit-frame\": \"j2000\""])
        {
            using HttpResponseMessage answer = await server.PostAsync(
                "/v1/render", $"{{\"states\": {states}, \"time\": \"{time}\", {Small}}}", "application/json");
            JsonElement information = (await RunningServer.JsonOf(answer)).GetProperty("GeneralInformation");
            JsonElement found = information.GetProperty("CameraPosition").GetProperty("Vector3D");
            Assert.Equal(time, information.GetProperty("SimulationTime").GetProperty("UTC").GetString());
            Assert.Equal(place[0], found.GetProperty("x").GetDouble(), SameMoment);
            Assert.Equal(place[1], found.GetProperty("y").GetDouble(), SameMoment);
            Assert.Equal(place[2], found.GetProperty("z").GetDouble(), SameMoment);
        }

        await server.DisposeAsync();
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"states\": \"other.oem\"", "'states' is 'other.oem', which is not a trajectory of this server")]
    [InlineData("\"states\": \"../orbit.oem\"", "which is not a trajectory of this server")]
    [InlineData("\"states\": \"a.tab\"", "a.tab, line 1:")]
    [InlineData("\"states\": 7", "'states' is '7', which is not a trajectory")]
    [InlineData("\"states\": {}", "'states' is an object; a text or a number is needed")]
    [InlineData("\"states\": []", "'states' is empty. Give states, MJD rx ry rz vx vy vz each")]
    [InlineData(
        "\"states\": [[\"noon\", 2e6, 0, 0, 0, 1600, 0]]",
        "'states', state 1: 'noon' is not a number; write decimal or scientific notation with a decimal point, "
            + "e.g. -1737400.5 or +1.7374E+006; a time is an MJD (UTC), or")]
    [InlineData("\"states\": [[60328.5, \"2e6\", 0, 0, 0, 1600, 0]]", "'states', state 1: a list of 7 finite numbers is needed")]
    [InlineData("\"states\": [[60328.5, 2e6, 0, 0]]", "'states', state 1: a list of 7 finite numbers is needed: MJD rx ry rz vx vy vz.")]
    [InlineData("\"states\": [[60328.5, 2e6, 0, 0, 0, 1600, null]]", "'states', state 1: a list of 7 finite numbers")]
    [InlineData("\"states\": [[60328.5, 2e999, 0, 0, 0, 1600, 0]]", "'states', state 1: a list of 7 finite numbers")]
    [InlineData("\"states\": [[1e9, 2e6, 0, 0, 0, 1600, 0]]", "'states', state 1: The MJD 1000000000 is not a date")]
    [InlineData("\"states\": [[60328.5, 2e6, 0, 0, 0, 0, 0], [60328.5, 2e6, 0, 0, 0, 0, 0]]", "state 2: its time is not after")]
    [InlineData("\"states\": [[60328, 2e6, 0, 0, 0, 0, 0], [60329, 2e6, 0, 0, 0, 0, 0]], \"time\": 60330", "is outside")]
    [InlineData("\"states\": [[60328, 2e6, 0, 0, 0, 0, 0], [60329, 2e6, 0, 0, 0, 0, 0]]", "'states' needs one of --time")]
    [InlineData("\"states\": [[60328, 2e6, 0, 0, 0, 0, 0]], \"position\": [0, 0, 1e5], \"time\": 60328", "'states' exclude each other")]
    [InlineData("\"states\": [[60328, 2e6, 0, 0, 0, 0, 0]], \"orbit-frame\": \"moon-me-epoch\", \"time\": 60328", "no one epoch")]
    [InlineData("\"states\": [[60328, 1e6, 0, 0, 0, 0, 0]], \"time\": 60328", "inside the Moon")]
    public async Task WrongStates_AreRefusedByName(string states, string expected)
    {
        string batch = _folder.Write("a.tab", "55289 2e6 0 0 0 0 0 1\n");
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, batch));
        string time = states.Contains("\"time\"", StringComparison.Ordinal) || expected.Contains("--time", StringComparison.Ordinal)
            ? string.Empty
            : ", \"time\": 60328.5";

        using HttpResponseMessage answer = await server.PostAsync("/v1/render", $"{{{states}{time}, {Small}}}");

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(expected, (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
        await server.DisposeAsync();
    }

    private static (double Time, double[] State)[] States() =>
    [
        .. Enumerable.Range(0, 12).Select(minute =>
        {
            (double sin, double cos) = Math.SinCos(Rate * 60.0 * minute);
            return (
                60.0 * minute,
                (double[])[Radius * cos, Radius * sin, 0.0, -Radius * Rate * sin, Radius * Rate * cos, 0.0]);
        }),
    ];

    private static string Rows() => $"[{string.Join(", ", States().Select(
        row => $"[{string.Join(", ", row.State.Prepend(Start + (row.Time / Day)).Select(Text))}]"))}]";

    private static string RowsOfCalendarTimes() => $"[{string.Join(", ", States().Select(
        row => $"[\"2024-01-19T12:{row.Time / 60.0:00}:00Z\", {string.Join(", ", row.State.Select(Text))}]"))}]";

    private static string Oem() =>
        "CCSDS_OEM_VERS = 2.0\nMETA_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\n"
            + $"META_STOP\n{string.Concat(States().Select(row => $"2024-01-19T12:{row.Time / 60.0:00}:00 "
                + $"{string.Join(' ', row.State.Select(number => Text(number / 1000.0)))}\n"))}";

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static string Text(double number) => number.ToString("R", CultureInfo.InvariantCulture);
}
