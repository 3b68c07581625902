using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>SPICE's own inertial frames, in trajectories, attitudes and frame kernels, by both engines against CSPICE itself.</summary>
[Collection(SpiceItself.Name)]
public sealed class InertialFramesTests : IDisposable
{
    /// <summary>1: three chained rotations, each rounded.</summary>
    private const double Matrix = 5e-16 * 8.0;

    /// <summary>m, of 1.8e6 m; and as attitude, the matrices and a time that is known to 1e-7 s.</summary>
    private const double Position = 4e-9;
    private const double Attitude = 1e-10;

    private readonly TemporaryFolder _folder = new();

    /// <summary>NAIF, Frames Required Reading, "Built-in Inertial Reference Frames", in the order of their numbers.</summary>
    private static readonly string[] Names =
        [
            "J2000", "B1950", "FK4", "DE-118", "DE-96", "DE-102", "DE-108", "DE-111", "DE-114", "DE-122", "DE-125", "DE-130", "GALACTIC",
            "DE-200", "DE-202", "MARSIAU", "ECLIPJ2000", "ECLIPB1950", "DE-140", "DE-142", "DE-143",
        ];

    public static TheoryData<int> Numbers { get; } = [.. Enumerable.Range(1, Names.Length)];

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.CSpice)]
    [MemberData(nameof(Numbers))]
    public void Frame_BuiltIn_IsThatOfCSpiceEverywhere(int number)
    {
        string name = Names[number - 1];
        string sclk = _folder.Write("test.tsc", TestClock.Sclk);
        string frames = _folder.Write(
            "test.tf",
            TestClock.Frames.Replace("'TEST_SC'\nTKFRAME", $"'{name}'\nTKFRAME", StringComparison.Ordinal) + FixedFrame(name));
        (string spk, string ck) = (_folder["test.bsp"], _folder["test.bc"]);
        using (OpenedEphemeris started = Engines.CSpice(Engines.MetaKernel, sclk, frames))
        {
            Assert.NotNull(started.Engine.EngineName);
            SpiceItself.WriteSpk(spk, handle => WriteSpk(handle, name));
            SpiceItself.WriteCk(ck, handle => WriteCk(handle, name));
        }

        using (DafFile file = DafFile.Open(spk))
        {
            Assert.Equal(number, file.Summaries[0].Integers[2]);
        }

        string[] kernels = [Engines.MetaKernel, sclk, frames, spk, ck];
        using OpenedEphemeris cspice = Engines.CSpice(kernels);
        using OpenedEphemeris builtIn = Engines.BuiltIn(kernels);
        double time = TimeOfTick(cspice, CkSamples.Ticks[20] + 12345.0);
        double[] position = new double[3];
        SpiceItself.spkpos_c(
            SpiceItself.Bytes("-999"), Start + 30.0, SpiceItself.Bytes("J2000"), SpiceItself.Bytes("NONE"), SpiceItself.Bytes("MOON"),
            position, out _);
        SpiceItself.ThrowIfFailed();
        RotationMatrix camera = Pxform("TEST_SC", time);
        RotationMatrix turned = Pxform("TEST_FIXED", time);
        RotationMatrix itself = Pxform(name, time);
        Assert.InRange(Difference(itself, InertialFrames.FrameFromJ2000(number)), 0.0, Matrix);
        Assert.Equal((number, name), (InertialFrames.NumberOf(name), InertialFrames.NameOf(number)));
        foreach (OpenedEphemeris engine in (OpenedEphemeris[])[cspice, builtIn])
        {
            Vector3D found = new KernelTrajectory(engine, "-999").StateJ2000(Start + 30.0).Position;
            Assert.InRange((found - (1000.0 * new Vector3D(position[0], position[1], position[2]))).Length, 0.0, Position);
            Assert.InRange(Difference(camera, engine.Frames.FrameFromJ2000("TEST_SC", time)), 0.0, Attitude);
            Assert.InRange(Difference(turned, engine.Frames.FrameFromJ2000("TEST_FIXED", time)), 0.0, Matrix);

            // The program's own way to attitudes looks the frames up before it asks the engine.
            foreach (string frame in (string[])["TEST_SC", "TEST_FIXED"])
            {
                KernelAttitude attitude = new(engine, frame, InstrumentAxes.Parse("+x,+y"));
                RotationMatrix moon = engine.Engine.BodyFromJ2000(time);
                UnitQuaternion q = attitude.MoonFromCamera(
                    new TrajectoryPoint(engine.Engine.TimeScale.InstantOf(time), time, default, moon));
                Vector3D sight = moon.Transposed * (q * -Vector3D.UnitX);
                RotationMatrix expected = frame == "TEST_SC" ? camera : turned;
                Assert.InRange((sight - expected.Row2).Length, 0.0, Attitude);
            }
        }
    }

    private const double Start = 3.02e8;

    private static string FixedFrame(string name) =>
        $"""


        \begindata
        FRAME_TEST_FIXED          = -999200
        FRAME_-999200_NAME        = 'TEST_FIXED'
        FRAME_-999200_CLASS       = 4
        FRAME_-999200_CLASS_ID    = -999200
        FRAME_-999200_CENTER      = -999
        TKFRAME_-999200_RELATIVE  = '{name}'
        TKFRAME_-999200_SPEC      = 'ANGLES'
        TKFRAME_-999200_UNITS     = 'DEGREES'
        TKFRAME_-999200_AXES      = ( 1, 2, 3 )
        TKFRAME_-999200_ANGLES    = ( 10.0, -20.0, 30.0 )
        \begintext
        """;

    private static void WriteSpk(int handle, string frame)
    {
        double[] epochs = [.. Enumerable.Range(0, 12).Select(i => Start + (10.0 * i))];
        double[] states = [.. epochs.SelectMany(time => (double[])[1800.0, 100.0 + (1.6 * (time - Start)), -300.0, 0.0, 1.6, 0.0])];
        SpiceItself.spkw09_c(
            handle, -999, 301, SpiceItself.Bytes(frame), epochs[0], epochs[^1], SpiceItself.Bytes("test"), 3, epochs.Length, states,
            epochs);
    }

    private static void WriteCk(int handle, string frame)
    {
        double[] ticks = CkSamples.Ticks;
        double[] quaternions = [.. ticks.SelectMany((_, i) =>
        {
            UnitQuaternion q = UnitQuaternion.FromAxisAngle(new Vector3D(1.0, -0.5, 0.25), 0.3 + (0.01 * i));
            return (double[])[q.W, q.X, q.Y, q.Z];
        })];
        SpiceItself.ckw03_c(
            handle, ticks[0], ticks[^1], TestClock.Instrument, SpiceItself.Bytes(frame), 0, SpiceItself.Bytes("test"), ticks.Length, ticks,
            quaternions, new double[3 * ticks.Length], 1, [ticks[0]]);
    }

    private static double TimeOfTick(OpenedEphemeris engine, double tick)
    {
        Assert.NotNull(engine.Engine.EngineName);
        SpiceItself.sct2e_c(TestClock.Clock, tick, out double time);
        SpiceItself.ThrowIfFailed();
        return time;
    }

    private static RotationMatrix Pxform(string frame, double time)
    {
        double[] m = new double[9];
        SpiceItself.pxform_c(SpiceItself.Bytes("J2000"), SpiceItself.Bytes(frame), time, m);
        SpiceItself.ThrowIfFailed();
        return new RotationMatrix(new(m[0], m[1], m[2]), new(m[3], m[4], m[5]), new(m[6], m[7], m[8]));
    }

    private static double Difference(RotationMatrix a, RotationMatrix b) =>
        Math.Max((a.Row0 - b.Row0).Length, Math.Max((a.Row1 - b.Row1).Length, (a.Row2 - b.Row2).Length));
}
