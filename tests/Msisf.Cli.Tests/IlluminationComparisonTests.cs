using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// <c>msis illumination --compare</c> on files of the form that LOLA's archive has: polar stereographic PDS3 maps whose values are
/// DN * SCALING_FACTOR + OFFSET. They are made here of the maps of a first run, changed in a way that is counted by hand.
/// </summary>
public sealed class IlluminationComparisonTests : IDisposable
{
    private const int Side = 10;

    private static readonly string[] Run =
    [
        "illumination", "--corners", Corners(), "--cell", "1200", "--time-interval", "61041:6h:61071", "--ephemeris", "builtin", "--batch",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>LOLA's maps with half as wide pixels: shadow where it is never lit, but for one cell; light that is 0.02 higher.</summary>
    [Fact]
    public void Compare_MapsThatAreAlmostTheSame_CountsTheDifference()
    {
        Assert.Equal(0, CommandLineRun.Of([.. Run, "--output-dir", _folder["first"]]).ExitCode);
        float[] dark = Read("never_lit.npy");
        float[] disc = Read("disc.npy");
        int changed = Array.FindIndex(dark, value => value == 1.0f);
        Assert.True(changed >= 0 && dark.Any(value => value == 0.0f), "The region needs lit and dark cells.");
        string shadow = WriteMap("LPSR_88S_600M", 1.0, 0.0, 8, cell => cell == changed ? 0 : (int)dark[cell]);
        string light = WriteMap(
            "AVGVISIB_88S_600M", 0.000025, 0.5, 16, cell => (int)Math.Round((Math.Min(1.0, disc[cell] + 0.02) - 0.5) / 0.000025));

        CommandLineRun run = CommandLineRun.Of([.. Run, "--compare", shadow, "--compare", light, "--output-dir", _folder["first"]]);
        Assert.True(run.ExitCode == 0, run.Error);
        Dictionary<string, string[]> rows = File.ReadLines(_folder["first/comparison.csv"]).Skip(1).Select(row => row.Split(','))
            .ToDictionary(row => $"{row[0]} {row[1]}");
        int count = dark.Count(value => value == 1.0f);
        Check(rows["LPSR_88S_600M cells compared"], Side * Side, Side * Side, 0.0);
        double even = 1e-4 * count; // km2: so near to the pole, cells have the same area on the ground to some 1e-5
        Check(rows["LPSR_88S_600M in shadow for ever"], 1.44 * count, 1.44 * (count - 1), even);
        Check(rows["LPSR_88S_600M in shadow in both"], 1.44 * (count - 1), 1.44 * (count - 1), even);
        Check(rows["LPSR_88S_600M in shadow in one alone"], 1.44, 0.0, even);
        Check(rows["AVGVISIB_88S_600M mean visible part of the Sun"], disc.Average(), disc.Average() + 0.02, 1e-4);
        Check(rows["AVGVISIB_88S_600M rms difference of it"], 0.02, 0.02, 1e-4);
        string[] best = rows.Single(row => row.Key.StartsWith("AVGVISIB_88S_600M best 1 of msisf at", StringComparison.Ordinal)).Value;
        Check(best, disc.Max(), disc.Max() + 0.02, 1e-4);
        Assert.Contains("LOLA's maps are of the ground over 18.6 years", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("LDEM_88S_600M", 1.0, "PRODUCT_ID = LDEM_88S_600M")]
    [InlineData("AVGVISIB_88S_600M_EARTH", 1.0, "LPSR_*.LBL or AVGVISIB_*.LBL")]
    [InlineData("AVGVISIB_88S_600M", 7.0, "line 0, sample 0: 7 by the label's SCALING_FACTOR")]
    public void Compare_OtherMaps_IsOneClearLine(string product, double scaling, string message)
    {
        string map = WriteMap(product, scaling, 0.0, 8, _ => 1);
        CommandLineRun run = CommandLineRun.Of([.. Run, "--compare", map, "--output-dir", _folder["w"]]);
        string error = Assert.Single(run.Error.Split('\n'), line => line.Contains("error:", StringComparison.Ordinal));
        Assert.Equal((2, string.Empty), (run.ExitCode, run.Output));
        Assert.Contains(message, error, StringComparison.Ordinal);
    }

    /// <summary>Corners of 10 x 10 cells of 1,200 m from the pole on, X and Y above 0, on LOLA's map of the south.</summary>
    private static string Corners()
    {
        double far = 90.0 - double.RadiansToDegrees(2.0 * Math.Atan(Side * 1200.0 * Math.Sqrt(2.0) / (2.0 * 1_737_400.0)));
        return string.Create(CultureInfo.InvariantCulture, $"-90,0,{-far:R},45");
    }

    private static void Check(string[] row, double ours, double theirs, double tolerance)
    {
        Assert.Equal(ours, double.Parse(row[2], CultureInfo.InvariantCulture), tolerance);
        Assert.Equal(theirs, double.Parse(row[3], CultureInfo.InvariantCulture), tolerance);
    }

    private float[] Read(string name)
    {
        byte[] bytes = File.ReadAllBytes(_folder[$"first/{name}"]);
        return MemoryMarshal.Cast<byte, float>(bytes.AsSpan(10 + BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(8)))).ToArray();
    }

    /// <summary>A map of 20 x 20 pixels of 600 m over the same place; line 0 at the top, as the run's.</summary>
    private string WriteMap(string product, double scaling, double offset, int bits, Func<int, int> valueOf)
    {
        const int Pixels = 2 * Side;
        byte[] image = new byte[Pixels * Pixels * bits / 8];
        for (int i = 0; i < Pixels * Pixels; i++)
        {
            int value = valueOf((i / Pixels / 2 * Side) + (i % Pixels / 2));
            if (bits == 8)
            {
                image[i] = (byte)value;
            }
            else
            {
                BinaryPrimitives.WriteInt16LittleEndian(image.AsSpan(2 * i), (short)value);
            }
        }

        string label = string.Create(CultureInfo.InvariantCulture, $"""
            PDS_VERSION_ID = PDS3
            PRODUCT_ID = "{product}"
            RECORD_TYPE = FIXED_LENGTH
            RECORD_BYTES = {Pixels * bits / 8}
            FILE_RECORDS = {Pixels}
            ^IMAGE = "{product}.IMG"
            OBJECT = IMAGE
              LINES = {Pixels}
              LINE_SAMPLES = {Pixels}
              SAMPLE_TYPE = {(bits == 8 ? "LSB_UNSIGNED_INTEGER" : "LSB_INTEGER")}
              SAMPLE_BITS = {bits}
              SCALING_FACTOR = {scaling:R}
              OFFSET = {offset:R}
            END_OBJECT = IMAGE
            OBJECT = IMAGE_MAP_PROJECTION
              MAP_PROJECTION_TYPE = "POLAR STEREOGRAPHIC"
              A_AXIS_RADIUS = 1737.4 <KM>
              CENTER_LATITUDE = -90 <DEG>
              CENTER_LONGITUDE = 0 <DEG>
              MAP_SCALE = 600 <M/PIXEL>
              LINE_PROJECTION_OFFSET = {Pixels - 0.5}
              SAMPLE_PROJECTION_OFFSET = -0.5
            END_OBJECT = IMAGE_MAP_PROJECTION
            END

            """);
        _folder.Write($"{product}.IMG", image);
        return _folder.Write($"{product}.LBL", Encoding.ASCII.GetBytes(label));
    }
}
