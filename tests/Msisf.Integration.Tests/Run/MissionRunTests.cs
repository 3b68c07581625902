using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Cameras on LRO by its kernels, from the command line.</summary>
public sealed class MissionRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private static string[] Position => ["--spk", LroNac.Spk, "--spacecraft", "LRO"];

    private static string[] Attitude => [.. LroNac.Cks.SelectMany(path => (string[])["--ck", path]), "--instrument", "LRO_LROCNACL"];

    private static string[] Texts => [.. LroNac.TextKernels.SelectMany(path => (string[])["--kernels", path])];

    public void Dispose() => _folder.Dispose();

    /// <summary>Degrees: CSPICE's time is a double, of which half a step is 3e-8 s, in which the camera flies 5e-5 m.</summary>
    private const double RoundingOfTime = 5e-9;

    [RequiresFact(Part.LroNac, Part.CSpice, Part.Ldem4)]
    public void DryRun_EveryFiveSeconds_IsTheSameWithBothEngines()
    {
        JsonElement[] cspice = Rows("cspice");
        JsonElement[] builtIn = Rows("builtin");

        Assert.Equal(3, cspice.Length);
        Assert.Equal("2009-07-30T12:20:38.185Z", cspice[1].GetProperty("utc").GetString());
        foreach ((JsonElement a, JsonElement b) in cspice.Zip(builtIn))
        {
            foreach (string name in (string[])["camera_latitude_deg", "camera_longitude_deg", "boresight_latitude_deg", "off_nadir_deg"])
            {
                Assert.Equal(a.GetProperty(name).GetDouble(), b.GetProperty(name).GetDouble(), RoundingOfTime);
            }
        }

        // LROC's page of the image: 33.96 N, 140.3 E in its middle, slewed by 1.65 degrees.
        Assert.Equal(1.64, cspice[1].GetProperty("off_nadir_deg").GetDouble(), 0.01);

        JsonElement[] Rows(string engine)
        {
            CommandLineRun run = CommandLineRun.Of(
            [
                .. Texts, .. Position, .. Attitude, "--every", "5", "--renderer", "native", "--ephemeris", engine, "--dry-run", "--format",
                "json",
            ]);
            Assert.True(run.ExitCode == 0, run.Error);
            return [.. JsonDocument.Parse(run.Output).RootElement.EnumerateArray()];
        }
    }

    [RequiresFact(Part.LroNac, Part.Ldem4)]
    public void Render_ByKernels_NamesThemAndTheFrameInTheMetaFile()
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            .. Texts, .. Position, .. Attitude, "--time", "2009-07-30T12:20:38.185Z", "--renderer", "native", "--fov", "5", "--width", "24",
            "--height", "20", "--output-dir", _folder["out"], "--ephemeris", "builtin",
        ]);

        Assert.True(run.ExitCode == 0, run.Error);
        string meta = File.ReadAllText(Directory.GetFiles(_folder["out"], "*.xml").Single());
        Assert.Contains(
            "<!-- MOON_ME: orientation 31006 of moon_pa_de421_1900-2050.bpc, by moon_080317.tf -->", meta, StringComparison.Ordinal);
        Assert.Contains("name=\"M103595705LE_1.bsp\" bytes=\"5120\"", meta, StringComparison.Ordinal);
        Assert.Contains("name=\"lrolc_2009181_2009213_v10_1_sliced_-85600.bc\"", meta, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.LroNac, Part.Ldem4)]
    [InlineData("outside", "20:20Z is outside what the kernels have of LRO (-85): 2009-07-30T12:20:34Z to 2009-07-30T12:20:43Z. Choose")]
    [InlineData("no such spacecraft", "No kernel has positions of CASSINI (-82). The kernels have LRO (-85)")]
    [InlineData("no such name", "has the name 'Orion'. The kernels have LRO (-85), ")]
    [InlineData("no clock", "No kernel has the clock of spacecraft -85, in whose ticks the CK counts. Add its SCLK kernel with --kernels.")]
    [InlineData("no attitude", "No CK has the attitude of LRO_SPACECRAFT (-85000), on which frame LRO_LROCNACL depends.")]
    [InlineData("no frame kernel", "Add its instrument and frame kernel with --kernels")]
    [InlineData("no instrument kernel", "No kernel has INS-85600_ITRANSS of LRO_LROCNACL")]
    [InlineData("no spacecraft", "--spk needs one of --spacecraft, --oem: what says where the camera is. Add it.")]
    [InlineData("no instrument", "--ck needs --instrument: whose attitude the camera has. Add it.")]
    [InlineData("no time", "--spacecraft needs one of --time, --times, --time-interval, --every")]
    [InlineData("with look-at", "--ck has no meaning where --attitude, --look-at")]
    [InlineData("wrong axes", "'+x,-x' are not axes")]
    [InlineData("povray", "has a lens with distortion, which POV-Ray can't draw")]
    public void Run_WrongInput_SaysWhatAndWhatToDo(string name, string expected)
    {
        string[] time = ["--time", "2009-07-30T12:20:38.185Z"];
        string[] native = ["--renderer", "native"];
        string[] frames = ["--kernels", LroNac.TextKernels[1]];
        string[] arguments = name switch
        {
            "outside" => [.. Texts, .. Position, .. Attitude, "--time", "2009-07-30T12:20:20Z", .. native],
            "no such spacecraft" => ["--spk", LroNac.Spk, "--spacecraft", "Cassini", .. time],
            "no such name" => ["--spk", LroNac.Spk, "--spacecraft", "Orion", .. time],
            "no clock" => [.. Texts[2..], .. Position, .. Attitude, .. time, .. native],
            "no attitude" => [.. Texts, .. Position, .. Attitude[2..], .. time, .. native],
            "no frame kernel" => [.. Position, .. Attitude, "--fov", "3", .. time],
            "no instrument kernel" => ["--kernels", LroNac.Clock, .. frames, .. Position, .. Attitude, "--fov", "3", .. time],
            "no spacecraft" => ["--spk", LroNac.Spk, .. time],
            "no instrument" => [.. Position, "--ck", LroNac.Cks[0], .. time],
            "no time" => Position,
            "with look-at" => [.. Position, .. Attitude, "--look-at", "nadir", "--fov", "3", .. time],
            "wrong axes" => [.. Texts, .. Position, .. Attitude, "--instrument-axes", "+x,-x", .. time, .. native],
            _ => [.. Texts, .. Position, .. Attitude, .. time, "--renderer", "povray"],
        };

        CommandLineRun run = CommandLineRun.Of([.. arguments, "--ephemeris", "builtin", "--output-dir", _folder["out"]]);

        Assert.InRange(run.ExitCode, 1, 3);
        string error = Assert.Single(run.Error.Split('\n'), line => line.StartsWith("msis: error: ", StringComparison.Ordinal));
        Assert.Contains(expected, error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }

    /// <summary>A size that can't be, and a position that is no number, in the segment of LRO.</summary>
    [RequiresTheory(Part.LroNac, Part.CSpice)]
    [InlineData("cspice", 428, 8.0, "damaged.bsp: damaged kernel: in the segment of -85, number 1 from its end is 8")]
    [InlineData("builtin", 428, 8.0, "damaged.bsp: damaged kernel: in the segment of -85, number 1 from its end is 8")]
    [InlineData("cspice", 385 + 14, double.NaN, "damaged.bsp: damaged kernel: the state of LRO (-85) is not finite")]
    [InlineData("builtin", 385 + 14, double.NaN, "damaged.bsp: damaged kernel: in the segment of -85, a number is not finite")]
    public void Run_DamagedSpk_IsNamedByBothEngines(string engine, int address, double value, string expected)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "states", "--spk", Damaged(address, value), "--spacecraft", "LRO", "--time", "2009-07-30T12:20:38.185Z", "--ephemeris", engine,
        ]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(expected, run.Error, StringComparison.Ordinal);
        Assert.Empty(run.Output);
    }

    [RequiresFact(Part.LroNac)]
    public void BatchConvert_CameraOfAnInstrumentKernel_IsRefused()
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "batchconvert", "--format", "sh", "--script", _folder["run.sh"], "--pieces", "1", .. Texts, .. Position, .. Attitude, "--every",
            "5", "--renderer", "native", "--output-dir", _folder["out"],
        ]);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("gives the camera of its instrument kernel, which the pieces of a run do not read", run.Error);
        Assert.False(File.Exists(_folder["run.sh"]));
    }

    [RequiresFact(Part.LroNac)]
    public void Kernels_OfLro_AreListed()
    {
        CommandLineRun table = CommandLineRun.Of(["kernels", LroNac.Spk, LroNac.Cks[0], .. LroNac.TextKernels]);
        CommandLineRun json = CommandLineRun.Of(["kernels", "--format", "json", LroNac.Cks[0]]);

        Assert.Equal(0, table.ExitCode);
        Assert.Matches(
            @"M103595705LE_1\.bsp +SPK +little +LRO \(-85\) +MOON \(301\) +J2000 \(1\) +13 +2009-07-30T12:20:33\.18[45]\d*Z", table.Output);
        Assert.Matches(@"moc42r\S+ +CK +little +LRO_SPACECRAFT \(-85000\) +J2000 \(1\) +- +3 +2009-07-30T12:20:33\.18", table.Output);
        JsonElement ck = Assert.Single(JsonDocument.Parse(json.Output).RootElement.EnumerateArray());
        Assert.Equal(-85000, ck.GetProperty("object").GetInt32());
        Assert.Contains("the clock of spacecraft -85 (SCLK) is missing", ck.GetProperty("note").GetString(), StringComparison.Ordinal);
    }

    private string Damaged(int address, double value)
    {
        byte[] bytes = File.ReadAllBytes(LroNac.Spk);
        BitConverter.GetBytes(value).CopyTo(bytes, (address - 1) * 8);
        return _folder.Write("damaged.bsp", bytes);
    }
}
