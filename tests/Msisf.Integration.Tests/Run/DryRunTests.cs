using System.Buffers.Binary;
using System.Globalization;
using System.Text.Json;
using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Integration.Tests.Run;

/// <summary>What <c>--dry-run</c> says of a frame, against the layers of the drawn frame of the real Moon.</summary>
public sealed class DryRunTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>
    /// Parts of the image: the Moon's relief, up to 10 km, moves the limb by 0.006 radii; the sphere's share itself is right to 0.003
    /// (docs/command-line-rules.md names the sum).
    /// </summary>
    private const double MoonTolerance = 0.01;

    /// <summary>Parts of the Moon in the image: where the Sun stands over the horizontal plane hardly depends on the relief.</summary>
    private const double DayTolerance = 0.01;

    /// <summary>Parts of the Moon in the image: with a Sun 10 degrees high or more, few slopes of a model of 4 px/deg are dark.</summary>
    private const double LitTolerance = 0.02;

    /// <summary>The same beside the terminator: shadows of mountains, which the sphere does not have, take a part of the day.</summary>
    private const double Shadows = 0.25;

    private const int Side = 128;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The Sun of MJD 55289 stands over 1.5 degrees north, 315.9 degrees east.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("nadir by day", 100e3, -20.0, 300.0, 0.0, 0.0, 40.0, false)]
    [InlineData("nadir at the terminator", 300e3, 30.0, 45.0, 0.0, 0.0, 60.0, true)]
    [InlineData("whole disc", 3e6, 10.0, 20.0, 0.0, 0.0, 60.0, false)]
    [InlineData("thin crescent", 20e6, 0.0, 125.0, 0.0, 0.0, 10.0, false)]
    [InlineData("limb", 200e3, 0.0, 330.0, 65.0, 40.0, 30.0, false)]
    [InlineData("over the pole", 150e3, 89.5, 0.0, 30.0, 200.0, 60.0, true)]
    [InlineData("low over Mare Imbrium", 5e3, 33.0, 344.0, 75.0, 300.0, 50.0, false)]
    [InlineData("night side", 150e3, 0.0, 136.0, 10.0, 0.0, 40.0, false)]
    [InlineData("away from the Moon", 150e3, 0.0, 0.0, 150.0, 0.0, 40.0, false)]
    public void DryRun_Shares_AreThoseOfTheDrawnFrame(
        string name, double height, double latitude, double longitude, double offNadir, double azimuth, double fov,
        bool isLowSun)
    {
        string state = State(height, latitude, longitude, offNadir, azimuth);
        string[] common =
        [
            "--fixed-state", state, "--fov", fov.ToString("R", CultureInfo.InvariantCulture), "--width", $"{Side}", "--height", $"{Side}",
            "--ldem", TestParts.Ldem4Label!, "--renderer", "native", "--lod", "off", "--ephemeris", "builtin",
        ];
        CommandLineRun drawn = CommandLineRun.Of(
            [.. common, "--layers", "mask,range", "--layers-format", "npy", "--output-dir", _folder.Path, "--output-name", "view"]);
        CommandLineRun dry = CommandLineRun.Of([.. common, "--dry-run", "--format", "json"]);

        Assert.True(drawn.ExitCode == 0 && dry.ExitCode == 0, drawn.Error + dry.Error);
        byte[] mask = Array(_folder["view.mask.npy"]);
        double moon = mask.Count(state => state != 0);
        double lit = mask.Count(state => state is 1 or 2);
        using JsonDocument document = JsonDocument.Parse(dry.Output);
        JsonElement row = document.RootElement[0];
        double moonSaid = row.GetProperty("moon_fraction").GetDouble();
        JsonElement litValue = row.GetProperty("lit_fraction");
        double? litSaid = litValue.ValueKind == JsonValueKind.Null ? null : litValue.GetDouble();
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name}: Moon {moonSaid:F4}, drawn {moon / mask.Length:F4}; lit {litSaid:F4}, drawn {lit / Math.Max(1.0, moon):F4}"));
        Assert.Equal(moon / mask.Length, moonSaid, MoonTolerance);
        Assert.Equal(moon > 0.0, litSaid is not null);
        if (moon > 0.0)
        {
            Assert.Equal(mask.Count(state => state is 1 or 2 or 3) / moon, litSaid!.Value, DayTolerance);
            Assert.InRange(lit / moon, litSaid.Value - (isLowSun ? Shadows : LitTolerance), litSaid.Value + LitTolerance);
            AssertPixelSize(row, offNadir);
        }
    }

    /// <summary>A normal run says the same on standard error, and only of its own frames; standard output is left to the files.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_SomeFrames_NotesWhatIsStrikingAboutThem()
    {
        string[] run =
        [
            "--kepler-set", "{1.9E6,0.05,0.7,1.1,0.9,2.0}", "--epoch", "55289", "--time-interval", "[55289:0.01:55289.1]", "--batch",
            "--width", "16", "--height", "16", "--ldem", TestParts.Ldem4Label!, "--renderer", "native", "--ephemeris", "builtin",
        ];

        CommandLineRun some = CommandLineRun.Of([.. run, "--frames", "2:7", "--output-dir", _folder.Path]);
        CommandLineRun dry = CommandLineRun.Of([.. run, "--frames", "2:7", "--dry-run"]);

        Assert.Equal(0, some.ExitCode);
        string note = Assert.Single(some.Error.Split('\n'), line => line.Contains(" lit ground", StringComparison.Ordinal));
        Assert.Equal("msis: 2 of 6 frames show no lit ground (steps 6:7).", note);
        Assert.Contains(note, dry.Error, StringComparison.Ordinal);
        Assert.All(some.Output.TrimEnd().Split('\n'), line => Assert.StartsWith(_folder.Path, line, StringComparison.Ordinal));
    }

    /// <summary>Where the terrain's shape hardly matters, straight below, the ground is as far away as the model has it.</summary>
    private void AssertPixelSize(JsonElement row, double offNadir)
    {
        if (offNadir == 0.0)
        {
            byte[] ranges = Array(_folder["view.range.npy"]);
            double range = BinaryPrimitives.ReadDoubleLittleEndian(ranges.AsSpan(8 * ((Side / 2 * Side) + (Side / 2))));
            Assert.Equal(1.0, row.GetProperty("height_over_terrain_m").GetDouble() / range, 0.01);
        }
    }

    /// <summary>The bytes of an array file after its head.</summary>
    private static byte[] Array(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        return file[(10 + BinaryPrimitives.ReadUInt16LittleEndian(file.AsSpan(8)))..];
    }

    private static string State(double height, double latitude, double longitude, double offNadir, double azimuth)
    {
        Vector3D up = new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
        Vector3D position = (MoonConstants.ReferenceRadius + height) * up;
        UnitQuaternion nadir = NadirPointing.MoonFromCamera(position);
        Vector3D east = nadir * Vector3D.UnitY;
        Vector3D north = nadir * Vector3D.UnitZ;
        (double sinAzimuth, double cosAzimuth) = Math.SinCos(double.DegreesToRadians(azimuth));
        (double sin, double cos) = Math.SinCos(double.DegreesToRadians(offNadir));
        Vector3D along = (sinAzimuth * east) + (cosAzimuth * north);
        UnitQuaternion q = CameraCases.Attitude((sin * along) - (cos * up), (cosAzimuth * east) - (sinAzimuth * north));
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{{55289,{position.X:R},{position.Y:R},{position.Z:R},{q.X:R},{q.Y:R},{q.Z:R},{q.W:R}}}");
    }
}
