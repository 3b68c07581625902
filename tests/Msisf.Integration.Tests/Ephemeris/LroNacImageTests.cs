using System.Text.Json;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>
/// LRO's image M103595705LE by its kernels, against its camera model ("ISD") by USGS ALE: positions, pointing, Sun and lines of sight.
/// </summary>
[Collection(SpiceItself.Name)] // alone: other kernels in turn would be loaded anew for each call
public sealed class LroNacImageTests
{
    /// <summary>1: as the issue asks for.</summary>
    private const double Relative = 1e-9;

    /// <summary>px: as the issue asks for.</summary>
    private const double LineOfSight = 1e-3;

    private static readonly Lazy<JsonElement> Isd = new(() => JsonDocument.Parse(File.ReadAllText(LroNac.Isd)).RootElement);

    public static TheoryData<EphemerisChoice> Choices { get; } = [EphemerisChoice.CSpice, EphemerisChoice.BuiltIn];

    [RequiresTheory(Part.CSpice, Part.LroNac)]
    [MemberData(nameof(Choices))]
    public void Trajectory_AllLines_IsThatOfTheIsd(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Open(choice);
        KernelTrajectory trajectory = new(opened, "LRO");
        JsonElement positions = Isd.Value.GetProperty("instrument_position");
        double[] times = Numbers(positions.GetProperty("ephemeris_times"));
        Assert.Equal(401, times.Length);
        for (int line = 0; line < times.Length; line++)
        {
            StateVector state = trajectory.StateJ2000(times[line]);
            AssertClose(1000.0 * Vector(positions.GetProperty("positions")[line]), state.Position);
            AssertClose(1000.0 * Vector(positions.GetProperty("velocities")[line]), state.Velocity);
        }
    }

    [RequiresTheory(Part.CSpice, Part.LroNac)]
    [MemberData(nameof(Choices))]
    public void Attitude_AllLines_IsThatOfTheIsd(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Open(choice);
        JsonElement pointing = Isd.Value.GetProperty("instrument_pointing");
        double[] times = Numbers(pointing.GetProperty("ephemeris_times"));
        for (int line = 0; line < times.Length; line++)
        {
            // J2000 to sensor, scalar first.
            double[] q = Numbers(pointing.GetProperty("quaternions")[line]);
            UnitQuaternion sensorFromJ2000 = UnitQuaternion.FromComponents(q[1], q[2], q[3], q[0], isRounded: true);
            RotationMatrix actual = opened.Frames.FrameFromJ2000("LRO_LROCNACL", times[line]);
            AssertClose(sensorFromJ2000 * Vector3D.UnitX, actual * Vector3D.UnitX);
            AssertClose(sensorFromJ2000 * Vector3D.UnitY, actual * Vector3D.UnitY);
        }
    }

    /// <summary>The ISD's Sun has light time and stellar aberration, as seen from the Moon's centre.</summary>
    [RequiresTheory(Part.CSpice, Part.LroNac)]
    [MemberData(nameof(Choices))]
    public void Sun_BothEnds_IsThatOfTheIsd(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Open(choice);
        JsonElement sun = Isd.Value.GetProperty("sun_position");
        foreach ((double time, int index) in Numbers(sun.GetProperty("ephemeris_times")).Select((time, index) => (time, index)))
        {
            Instant utc = opened.Engine.TimeScale.InstantOf(time);
            Vector3D actual = opened.Engine.BodyFromJ2000(utc.Tdb).Transposed
                * opened.Engine.SunPositionBodyFixed(utc, Aberration.LightTimeAndStellar);
            AssertClose(1000.0 * Vector(sun.GetProperty("positions")[index]), actual);
        }
    }

    /// <summary>
    /// Where the camera's image, by kernels alone, has the lines of sight of the ISD: sample s looks along (0, y / (1 + k y2), f) in the
    /// sensor's axes with y = (s - s0) / 142.857 mm.
    /// </summary>
    [RequiresTheory(Part.CSpice, Part.LroNac)]
    [MemberData(nameof(Choices))]
    public void LinesOfSight_AllOverTheImage_AreThoseOfTheIsd(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Open(choice);
        InstrumentKernel instrument = new(opened.Catalogue.Pool, "LRO_LROCNACL");
        KernelAttitude attitude = new(opened, instrument.Frame, instrument.Axes());
        KernelTrajectory trajectory = new(opened, "-85");
        CameraModel model = instrument.Camera().Model;
        Assert.Equal((5064, 1), (model.Width, model.Height));

        JsonElement isd = Isd.Value;
        double focal = isd.GetProperty("focal_length_model").GetProperty("focal_length").GetDouble();
        double k = isd.GetProperty("optical_distortion").GetProperty("lrolrocnac").GetProperty("coefficients")[0].GetDouble();
        double center = isd.GetProperty("detector_center").GetProperty("sample").GetDouble();
        double perMillimetre = isd.GetProperty("focal2pixel_samples")[2].GetDouble();
        JsonElement pointing = isd.GetProperty("instrument_pointing");
        double[] times = Numbers(pointing.GetProperty("ephemeris_times"));
        for (int line = 0; line < times.Length; line += 25)
        {
            RotationMatrix moonFromJ2000 = opened.Engine.BodyFromJ2000(times[line]);
            StateVector state = trajectory.StateJ2000(times[line]);
            TrajectoryPoint point = new(opened.Engine.TimeScale.InstantOf(times[line]), times[line], state, moonFromJ2000);
            FrameCamera camera = model.At(new CameraState(point.PositionBodyFixed, attitude.MoonFromCamera(point)));
            double[] q = Numbers(pointing.GetProperty("quaternions")[line]);
            UnitQuaternion j2000FromSensor = UnitQuaternion.FromComponents(-q[1], -q[2], -q[3], q[0], isRounded: true);
            foreach (double sample in (double[])[0.5, 1.5, 1000.25, 2547.5, 2548.0, 4000.75, 5063.5])
            {
                // CSM: the centre of the first sample is at 0.5; here at 1.
                double y = (sample - 0.5 - center + 0.5) / perMillimetre;
                Vector3D look = moonFromJ2000 * (j2000FromSensor * new Vector3D(0.0, y / (1.0 + (k * y * y)), focal));
                Vector3D target = point.PositionBodyFixed + (50_000.0 / look.Length * look);
                Assert.True(camera.TryProjectPoint(target, out RenderingPoint seen));
                Assert.Equal(sample + 0.5, seen.X, LineOfSight);
                Assert.Equal(1.0, seen.Y, LineOfSight);
            }
        }
    }

    private static OpenedEphemeris Open(EphemerisChoice choice) =>
        Engines.Open(choice, [Engines.MetaKernel, .. LroNac.TextKernels, LroNac.Spk, .. LroNac.Cks]);

    private static void AssertClose(Vector3D expected, Vector3D actual) =>
        Assert.InRange((actual - expected).Length / expected.Length, 0.0, Relative);

    private static double[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];

    private static Vector3D Vector(JsonElement list) => new(list[0].GetDouble(), list[1].GetDouble(), list[2].GetDouble());
}
