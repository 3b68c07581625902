using System.Globalization;
using System.Text.Json;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>Kernels and CCSDS files from the field: each gives the value that stands beside it, or a refusal whose advice works.</summary>
public sealed class FieldKernelTests
{
    private const string AtPass = "--time 2010-04-06T20:11:35.5Z";

    /// <summary>02: clocks that differ in the form of a date only give the same attitude.</summary>
    [RequiresTheory(Part.Field, Part.CSpice)]
    [InlineData("builtin")]
    [InlineData("cspice")]
    public void Clock_AnyFormOfDate_IsRead(string engine)
    {
        string[] rows =
        [
            .. ((string[])["1", "2", "3", "_works"]).Select(clock => Row(
                "02", "--spk orbit.bsp --spacecraft -777 --ck attitude.bc --instrument CAMX --instrument-axes=+x,+y "
                    + $"--kernels clock{clock}.tsc --kernels frames.tf {AtPass} --ephemeris {engine}")),
        ];

        Assert.Single(rows.Distinct());
    }

    /// <summary>Real clocks: Kaguya's (ISO dates) and Apollo 15's (28-OCT-1994 and others).</summary>
    [RequiresTheory(Part.Field)]
    [InlineData("SEL_M_V01.TSC", -131)]
    [InlineData("apollo15.0001.tsc", -915)]
    public void Clock_OfRealMissions_IsRead(string name, int clock) => Assert.True(
        SpacecraftClock.IsIn(KernelPool.Of([Path.Combine(TestParts.Field, "kernels", name)]), clock));

    /// <summary>11: attitudes and trajectories in B1950, by both engines as CSPICE has them.</summary>
    [RequiresTheory(Part.Field, Part.CSpice)]
    [InlineData("builtin")]
    [InlineData("cspice")]
    public void B1950_InSpkAndCk_IsAsInCSpice(string engine)
    {
        using JsonDocument expected = JsonDocument.Parse(File.ReadAllText(Path.Combine(TestParts.Field, "11", "expected.json")));
        double[] camera = Numbers(Row(
            "11", "--spk orbit.bsp --spacecraft -777 --ck attitude_b1950.bc --instrument CAMX --instrument-axes=+x,+y --kernels clock.tsc "
                + $"--kernels frames.tf {AtPass} --ephemeris {engine}"));
        double[] place = Numbers(Row("11", $"--spk orbit_b1950.bsp --spacecraft -777 {AtPass} --ephemeris {engine}"));

        // Columns of the matrix are the instrument's axes; the camera looks along its z, with x to the right.
        double[][] rows = Matrix(expected.RootElement.GetProperty("CSPICE pxform CAMX->MOON_ME"));
        UnitQuaternion q = UnitQuaternion.FromComponents(camera[4], camera[5], camera[6], camera[7]);
        Assert.InRange(((q * -Vector3D.UnitX) - Column(rows, 2)).Length, 0.0, 1e-9);
        Assert.InRange(((q * Vector3D.UnitY) - Column(rows, 0)).Length, 0.0, 1e-9);
        JsonElement right = expected.RootElement.GetProperty("CSPICE position of orbit_b1950.bsp, m, MOON_ME");
        double[] position = [.. right.EnumerateArray().Select(x => x.GetDouble())];
        Vector3D off = new(place[1] - position[0], place[2] - position[1], place[3] - position[2]);

        // The expected position is CSPICE's, at the nearest double of time: the spacecraft flies 5e-5 m in half a step of it, 3e-8 s.
        Assert.InRange(off.Length, 0.0, engine == "cspice" ? 1e-6 : 5e-5);
    }

    /// <summary>14: one message has one spacecraft, whose ID tells it from others of its name.</summary>
    [RequiresFact(Part.Field)]
    public void Oem_TwoObjectIds_IsRefused() => Assert.Contains(
        "OBJECT_ID", Fails("14", "--oem two_ids.oem --every 300"), StringComparison.Ordinal);

    /// <summary>22: between the lines angles go on as their derivatives say.</summary>
    [RequiresFact(Part.Field)]
    public void Aem_AnglesAndDerivatives_AreFollowed()
    {
        using JsonDocument expected = JsonDocument.Parse(File.ReadAllText(Path.Combine(TestParts.Field, "22", "expected.json")));
        double[][] rows = Matrix(expected.RootElement.EnumerateObject().First().Value);

        double[] camera = Numbers(Row("22", "--oem orbit.oem --aem spin.aem --time 2010-04-06T20:01:40Z"));

        UnitQuaternion q = UnitQuaternion.FromComponents(camera[4], camera[5], camera[6], camera[7]);
        Assert.InRange(((q * Vector3D.UnitX) - Column(rows, 0)).Length, 0.0, 1e-9);
        Assert.InRange(((q * Vector3D.UnitZ) - Column(rows, 2)).Length, 0.0, 1e-9);
    }

    /// <summary>t1: the data of a class-4 frame stand under its class ID; in the real kernel of Lunar Orbiter too.</summary>
    [RequiresFact(Part.Field)]
    public void Frame_ClassIdOfAnother_HasItsData()
    {
        KernelPool pool = KernelPool.Of([Path.Combine(TestParts.Field, "t1", "class4_two.tf")]);
        FrameSystem frames = new(pool, () => throw new InvalidOperationException(), new SpacecraftAttitudes(pool, []));
        Assert.Equal(frames.FrameFromJ2000("BBB", 0.0), frames.FrameFromJ2000("AAA", 0.0));

        FrameDefinition real = FrameDefinition.Find(
            KernelPool.Of([Path.Combine(TestParts.Field, "t1", "lo02.ti")]), "LO3_MED_RESOLUTION_CAMERA")!;
        Assert.Equal((-533002, -533001, "LUNAR_ORBITER_3"), (real.Id, real.ClassId, real.Relative));
        Assert.Equal(RotationMatrix.Identity, real.RelativeFromFrame());
    }

    /// <summary>A kernel in the wrong place is called what it is; what the message says then works.</summary>
    [RequiresTheory(Part.Field)]
    [InlineData("--spk attitude.bc --spacecraft -777", "attitude.bc: this is a CK (attitudes). Give it with --ck in place of --spk.")]
    [InlineData(
        "--spk orbit.bsp --spacecraft -777 --ck clock_works.tsc --instrument CAMX --instrument-axes=+x,+y",
        "clock_works.tsc: this is a clock kernel (SCLK). Give it with --kernels in place of --ck.")]
    [InlineData("--oem orbit.bsp", "orbit.bsp: this is an SPK (trajectories). Give it with --spk in place of --oem.")]
    [InlineData(
        "--spk orbit.bsp --spacecraft -777 --aem attitude.bc",
        "attitude.bc: this is a CK (attitudes). Give it with --ck in place of --aem.")]
    public void Kernel_InTheWrongPlace_IsCalledWhatItIs(string run, string expected)
    {
        Assert.Contains(expected, Fails("02", $"{run} {AtPass}"), StringComparison.Ordinal);

        Row(
            "02", "--spk orbit.bsp --spacecraft -777 --ck attitude.bc --instrument CAMX --instrument-axes=+x,+y --kernels clock_works.tsc "
                + $"--kernels frames.tf {AtPass}");
    }

    [RequiresTheory(Part.Field, Part.CSpice)]
    [InlineData("builtin")]
    [InlineData("cspice")]
    public void Kernel_CutOff_IsCalledDamaged(string engine)
    {
        byte[] whole = File.ReadAllBytes(Path.Combine(TestParts.Field, "02", "orbit.bsp"));
        DirectoryInfo folder = Directory.CreateTempSubdirectory("msisf-cut-"); // without blanks, at which the words of a run end
        foreach (int length in (int[])[0, 5, 700, 1024, 2500, whole.Length - 1024])
        {
            string cut = Path.Combine(folder.FullName, $"cut{length}.bsp");
            File.WriteAllBytes(cut, whole[..length]);
            string message = Fails("02", $"--spk {cut} --spacecraft -777 {AtPass} --ephemeris {engine}");
            Assert.Contains(cut, message, StringComparison.Ordinal);
            Assert.Contains("anew", message, StringComparison.Ordinal);
        }

        folder.Delete(recursive: true);
    }

    /// <summary>The paths of this meta-kernel start at the folder in which the program runs, as SPICE takes them.</summary>
    [RequiresFact(Part.Field)]
    public void MetaKernel_PathsFromTheWorkingFolder_AreFound() => ChildRun.Of(
        TestedProgram.File,
        TestedProgram.Words(
            "states", "--kernels", "mk/mission.tm", "--position", "0,0,100000", "--time", "2010-04-06T20:24:00Z", "--format", "csv"),
        Path.Combine(TestParts.Field, "19")).Succeeded();

    /// <summary>A second apart by the rows' own velocities too, also across 23:59:60.</summary>
    [RequiresFact(Part.Field)]
    public void Oem_EverySecondOverALeapSecond_HasEachStateOnce()
    {
        CommandLineRun done = Run("t1", "--oem leap_second.oem --every 1 --off-nadir 0");
        double[][] rows = [.. done.Output.Split('\n').Where(line => line.StartsWith("577", StringComparison.Ordinal)).Select(Numbers)];

        Assert.Equal(241, rows.Length);
        foreach ((double[] first, double[] second) in rows.Zip(rows.Skip(1)))
        {
            for (int axis = 1; axis <= 3; axis++)
            {
                // m: the trapezium rule over a second, in which the acceleration of 1.5 m/s2 hardly changes
                Assert.Equal(0.5 * (first[axis + 7] + second[axis + 7]), second[axis] - first[axis], 0.001);
            }
        }
    }

    /// <summary>The last line of the table of states.</summary>
    private static string Row(string folder, string run)
    {
        CommandLineRun done = Run(folder, run);
        Assert.True(done.ExitCode == 0, done.Error);
        return done.Output.TrimEnd().Split('\n')[^1];
    }

    private static string Fails(string folder, string run)
    {
        CommandLineRun done = Run(folder, run);
        Assert.InRange(done.ExitCode, 1, 3);
        return done.Error;
    }

    private static CommandLineRun Run(string folder, string run) => CommandLineRun.Of(
    [
        "states", "--format", "csv", "--fov", "5",
        .. run.Split(' ').Select(word => File.Exists(Path.Combine(TestParts.Field, folder, word))
            ? Path.Combine(TestParts.Field, folder, word)
            : word),
    ]);

    private static double[] Numbers(string row) =>
        [.. row.Split(',').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

    private static double[][] Matrix(JsonElement rows) =>
        [.. rows.EnumerateArray().Select(row => row.EnumerateArray().Select(x => x.GetDouble()).ToArray())];

    private static Vector3D Column(double[][] rows, int index) => new(rows[0][index], rows[1][index], rows[2][index]);
}
