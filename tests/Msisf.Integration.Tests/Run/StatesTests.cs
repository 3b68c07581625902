using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using System.Globalization;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary><c>msis states</c>: what it writes is read back, by CSPICE and by msis itself.</summary>
public sealed class StatesTests : IDisposable
{
    private const string Orbit =
        "--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval [55289:0.0005:55289.11] --orbit-frame j2000 "
            + "--attitude {0.1,0.2,0.3,0.9273618495495704} --attitude-transition {1e-3,2e-3,-1e-3}";

    /// <summary>rad/s: above how fast any camera here turns.</summary>
    private const double FastestTurn = 2.5e-3;

    /// <summary>s: the table's MJD is a double, of which half a step is 0.32 microseconds; the kernels have the moment itself.</summary>
    private const double RoundingOfMjd = 3.2e-7;

    private readonly TemporaryFolder _folder = new();

    /// <summary>s: from state to state of <see cref="Orbit"/>.</summary>
    private const double Step = 43.2;

    /// <summary>rad/s: a turn over 0.02 s, between TDB times in doubles that are 6e-8 s apart, is so far off.</summary>
    private const double TimesOfTdb = FastestTurn * 6e-8 / 0.02;

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// More than 100 states have directories in the kernels; one alone is padded; times need not be in order. Of a camera off its axis the
    /// corners are those of its image: (0.5 - cx) / f, ...
    /// </summary>
    [RequiresTheory(Part.CSpice, Part.Python)]
    [InlineData(Orbit)]
    [InlineData("--fixed-state {55289,1.9E6,0,0,0.5,0.5,0.5,0.5}")]
    [InlineData("--position 10,20,50000 --look-at 12,21 --times {60000.5,60000,60001}")]
    public void Spice_ReadByCSpice_IsTheSamePose(string run)
    {
        Succeed(["states", "--format", "csv", "--to", _folder["states.csv"], .. run.Split(' ')]);
        Succeed(["states", "--format", "spice", "--to", _folder["kernels"], "--fov", "40", "--width", "200", "--height", "100",
            .. run.Split(' ')]);

        string[] lines = ChildRun.Of(
            TestParts.Python!,
            [
                "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "reference", "states_kernels.py"), TestParts.CSpiceLibrary!,
                TestParts.Kernels, _folder["kernels"], _folder["states.csv"],
            ],
            _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Assert.All(lines[0].Split(' '), error => Assert.InRange(
            double.Parse(error, CultureInfo.InvariantCulture), 0.0, Rounding.OfTurns + (FastestTurn * RoundingOfMjd)));
        string[] words = lines[1].Split(' ');
        Assert.Equal(["POLYGON", "MSISF_CAMERA"], words[..2]);
        double[] corners = [.. words[2..].Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
        double right = Math.Tan(20.0 * Math.PI / 180.0);
        double[] expected =
            [-right, -right / 2.0, 1.0, right, -right / 2.0, 1.0, right, right / 2.0, 1.0, -right, right / 2.0, 1.0];
        Assert.All(corners.Zip(expected), pair => Assert.Equal(pair.Second, pair.First, 1e-11)); // the kernel has 12 digits or more
    }

    /// <summary>SPK and CK reach a second beyond the states, and the CK says how fast the camera turns.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData("cspice")]
    [InlineData("builtin")]
    public void Spice_BeyondTheStates_CoversASecond(string name)
    {
        Succeed(["states", "--format", "spice", "--to", _folder["kernels"], "--fov", "40", .. Orbit.Split(' ')]);
        EphemerisChoice engine = name == "cspice" ? EphemerisChoice.CSpice : EphemerisChoice.BuiltIn;
        using OpenedEphemeris opened = Ephemeris.Engines.Open(
            engine, [Ephemeris.Engines.MetaKernel, .. Directory.GetFiles(_folder["kernels"]).Order(StringComparer.Ordinal)]);
        KernelTrajectory trajectory = new(opened, "-999");
        double start = opened.Engine.TimeScale.InstantOfMjd(55289.0).Tdb.Seconds;
        TdbInterval cover = Assert.Single(trajectory.Cover.Intervals);
        Assert.Equal(start - 1.0, cover.Start, 1e-6);
        TdbInterval turning = Assert.Single(opened.Catalogue.Attitudes.CoverOf(-999001).Intervals);
        Assert.Equal(start - 1.0, turning.Start, 1e-5);
        Assert.Equal(cover.End, turning.End, 1e-5);

        StateVector first = trajectory.StateJ2000(start);
        StateVector before = trajectory.StateJ2000(start - 0.75);
        Assert.InRange((before.Position - (first.Position - (0.75 * first.Velocity))).Length, 0.0, 1e-6);
        foreach (double after in (double[])[-0.75, 0.02, 21.6, 43.1, 4000.0, 4700.0, cover.End - start - 0.25])
        {
            double time = start + after;
            RotationMatrix earlier = opened.Frames.FrameFromJ2000("MSISF_CAMERA", time - 0.01);
            RotationMatrix turn = earlier * opened.Frames.FrameFromJ2000("MSISF_CAMERA", time + 0.01).Transposed;
            Vector3D rate = 0.5 / 0.02 * (earlier.Transposed * new Vector3D(
                turn.Row2.Y - turn.Row1.Z, turn.Row0.Z - turn.Row2.X, turn.Row1.X - turn.Row0.Y));
            Vector3D stated = opened.Catalogue.Frames.RateJ2000("MSISF_CAMERA", time)!.Value;
            Assert.InRange((rate - stated).Length, 0.0, TimesOfTdb + TurnsWithinAStep(after));
            Assert.InRange(stated.Length, 2.4e-3, 2.5e-3); // rad/s: that of --attitude-transition, over the Moon
        }
    }

    /// <summary>
    /// rad/s: between two states a CK turns at one rate, the mean, while the rates that it states change evenly from state to state. The
    /// camera turns evenly over the Moon, so that in its axes the Moon's own rate changes its direction.
    /// </summary>
    private static double TurnsWithinAStep(double sinceStart)
    {
        double part = sinceStart / Step;
        double fromMiddle = sinceStart < 0.0 || sinceStart > 220.0 * Step ? 0.0 : Math.Abs(part - Math.Floor(part) - 0.5);
        return fromMiddle * Step * FastestTurn * MoonConstants.RotationRate;
    }

    /// <summary>
    /// The kernels alone give msis the same poses and the same camera again: its pixels off the axis, not square and skew. The lens is left
    /// out, and both the file and the log say so.
    /// </summary>
    [Fact]
    public void Spice_ReadByMsis_IsTheSamePoseAndCamera()
    {
        const string Camera =
            "width: 60\nheight: 40\nfocal-length-px: [80, 76.5]\nprincipal-point: [33.25, 17.5]\nskew: 1.5\npixel-convention: isis\n";
        const string Lens = "distortion:\n  model: opencv\n  k1: 0.1\n";
        string[] of = ["--camera", _folder.Write("own.yaml", Camera + Lens), "--renderer", "native", .. Orbit.Split(' ')];
        double[][] first = Rows(Succeed(["states", "--format", "csv", .. of]));
        CommandLineRun run = CommandLineRun.Of(["states", "--format", "spice", "--to", _folder["kernels"], .. of]);
        string[] kernels =
        [
            "--spk", _folder["kernels/states.bsp"], "--spacecraft", "MSISF", "--ck", _folder["kernels/states.bc"],
            .. ((string[])["tsc", "tf", "ti"]).SelectMany(ending => (string[])["--kernels", _folder[$"kernels/states.{ending}"]]),
            "--instrument", "MSISF_CAMERA", "--time-interval", "[55289:0.0005:55289.11]",
        ];
        double[][] again = Rows(Succeed(["states", "--format", "csv", .. kernels]));
        CameraModel model = new InstrumentKernel(
            KernelPool.Of([_folder["kernels/states.ti"], _folder["kernels/states.tf"]]), "MSISF_CAMERA").Camera().Model;

        Assert.Contains("lens (opencv) is left out", run.Error);
        Assert.Contains("lens (opencv) is left out", File.ReadAllText(_folder["kernels/states.ti"]));
        Assert.Equal(first.Length, again.Length);
        foreach ((double[] a, double[] b) in first.Zip(again))
        {
            Assert.All(Enumerable.Range(1, 3), i => Assert.Equal(a[i], b[i], 2e-3)); // 1e-9 of the distance
            double sign = Math.Sign((a[4] * b[4]) + (a[5] * b[5]) + (a[6] * b[6]) + (a[7] * b[7]));
            Assert.All(Enumerable.Range(4, 4), i => Assert.Equal(a[i], sign * b[i], Rounding.OfPlaces));
        }

        Assert.Equal((60, 40), (model.Width, model.Height));
        double[] written = [80.0, 76.5, 33.25, 17.5, 1.5];
        double[] read = [model.FocalX, model.FocalY, model.PrincipalX, model.PrincipalY, model.Skew];
        foreach ((double expected, double actual) in written.Zip(read))
        {
            Assert.Equal(expected, actual, Rounding.OfPlaces);
        }
    }

    /// <summary>Files of CCSDS that msis wrote give msis the same states again; those printed as CSV and batch file too.</summary>
    [Fact]
    public void CcsdsCsvAndBatch_ReadBack_AreTheSameStates()
    {
        Succeed(["states", "--format", "csv", "--to", _folder["states.csv"], .. Orbit.Split(' ')]);
        Succeed(["states", "--format", "oem", "--to", _folder["ccsds"], .. Orbit.Split(' ')]);
        string printed = Succeed(["states", .. Orbit.Split(' ')]);
        File.WriteAllText(_folder["states.tab"], printed);
        double[][] first = Rows(File.ReadAllText(_folder["states.csv"]));

        double[][] again = Rows(Succeed(["states", "--format", "csv", "--batch-file", _folder["states.csv"]]));
        double[][] batch = Rows(Succeed(["states", "--format", "csv", "--batch-file", _folder["states.tab"]]));
        double[][] ccsds = Rows(Succeed(
        [
            "states", "--format", "csv", "--oem", _folder["ccsds/states.oem"], "--aem", _folder["ccsds/states.aem"], "--time-interval",
            "[55289:0.0005:55289.11]",
        ]));

        Assert.Equal(221, first.Length);
        Assert.Equal(first, again);
        Assert.Equal(first, batch);
        Assert.Equal(first.Length, ccsds.Length);
        foreach ((double[] a, double[] b) in first.Zip(ccsds))
        {
            Assert.Equal(a[0], b[0]);
            Assert.All(Enumerable.Range(1, 3), i => Assert.Equal(a[i], b[i], 2e-3)); // 1e-9 of the distance
            double sign = Math.Sign((a[4] * b[4]) + (a[5] * b[5]) + (a[6] * b[6]) + (a[7] * b[7]));
            Assert.All(Enumerable.Range(4, 4), i => Assert.Equal(a[i], sign * b[i], Rounding.OfPlaces));
            Assert.All(Enumerable.Range(8, 3), i => Assert.Equal(a[i], b[i], 5e-3)); // m/s: at the ends, of one side
        }
    }

    [Theory]
    [InlineData("--format tum", "timestamp tx ty tz qx qy qz qw (scalar last)", 1)]
    [InlineData("--format euroc", "q_RS_w [],q_RS_x []", 4)]
    [InlineData("--format colmap", "PINHOLE 512 512", 3)]
    [InlineData("--format oem", "QUATERNION_TYPE = LAST", 2)]
    [InlineData("--format csv --frames 2:3", "qx, qy, qz, qw (scalar last)", 1)]
    public void EachFormat_NamesItsQuaternion(string options, string expected, int files)
    {
        string output = Succeed(
            ["states", .. options.Split(' '), "--to", _folder["out"], "--width", "512", "--height", "512", .. Orbit.Split(' ')]);

        string[] paths = output.TrimEnd().Split('\n');
        Assert.Equal(files, paths.Length);
        Assert.Contains(expected, string.Concat(paths.Select(File.ReadAllText)));
        Assert.All(paths, path => Assert.DoesNotContain("NaN", File.ReadAllText(path)));
    }

    [Theory]
    [InlineData(
        "--format spice --fixed-state {55289,1.9E6,0,0,0,0,0,1}", 1,
        "--format spice writes several files. Give the folder for them: --to DIR.")]
    [InlineData(
        "--format oem --to OUT --position 10,20,50000 --times {60000,60000}", 2, "two states of the run are of 2023-02-25T00:00:00Z")]
    [InlineData("--format obj --fixed-state {55289,1.9E6,0,0,0,0,0,1}", 1, "--format")]
    public void Wrong_IsOneLine(string words, int exitCode, string expected)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["states", .. words.Split(' ').Select(word => word == "OUT" ? _folder["out"] : word)]);

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Contains(expected, run.Error);
        Assert.DoesNotContain("   at ", run.Error);
        Assert.False(File.Exists(_folder["out/states.oem"]));
    }

    /// <summary>A trajectory about the Moon is none about Mars.</summary>
    [Fact]
    public void OemOfTheMoon_WithAnotherBody_IsRefused()
    {
        Succeed(["states", "--format", "oem", "--to", _folder.Path, .. Orbit.Split(' ')]);

        CommandLineRun model = CommandLineRun.Of(
            ["ldem", "synthesize", "--res", "1", "--body", "mars", "--seed", "1", "--output-dir", _folder.Path, "--batch"]);
        Assert.True(model.ExitCode == 0, model.Error);

        CommandLineRun run = CommandLineRun.Of(
        [
            "states", "--oem", _folder["states.oem"], "--every", "600", "--body", "mars", "--renderer", "native", "--res", "1", "--ldem",
            _folder["MARS_DEM_1_SYNTHETIC.LBL"],
        ]);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("--oem reads trajectories about Moon and Earth, but Mars is drawn. Give an SPK.", run.Error);
    }

    private static double[][] Rows(string csv) =>
    [
        .. csv.TrimEnd().Split('\n').Where(line => line[0] is >= '0' and <= '9')
            .Select(line => line.Split(',').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray()),
    ];

    private static string Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of([.. arguments, .. TestParts.Ldem4Label is { } label ? ["--ldem", label] : (string[])[]]);
        Assert.True(run.ExitCode == 0, run.Error);
        return run.Output;
    }
}
