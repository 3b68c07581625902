using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using Msisf.TestSupport;
using System.Text;

namespace Msisf.Adapters.Tests.Ccsds;

/// <summary>Small files, and what they are read with.</summary>
internal static class CcsdsTexts
{
    /// <summary>Four states a minute apart: x grows by 1 km/s, y is the minute squared.</summary>
    public const string Oem = """
        CCSDS_OEM_VERS = 2.0
        COMMENT made by hand
        CREATION_DATE = 2024-01-18T00:00:00
        ORIGINATOR = TEST

        META_START
        OBJECT_NAME = ORBITER
        OBJECT_ID = 2024-001A
        CENTER_NAME = MOON
        REF_FRAME = EME2000
        TIME_SYSTEM = UTC
        START_TIME = 2024-01-19T12:00:00.000
        STOP_TIME = 2024-01-19T12:03:00.000
        INTERPOLATION = HERMITE
        INTERPOLATION_DEGREE = 7
        META_STOP
        2024-01-19T12:00:00.000 2000.0 0.0 0.0 1.0 0.0 0.0
        2024-01-19T12:01:00.000 2060.0 1.0 0.0 1.0 0.0333333333333 0.0
        2024-01-19T12:02:00.000 2120.0 4.0 0.0 1.0 0.0666666666667 0.0
        2024-01-19T12:03:00.000 2180.0 9.0 0.0 1.0 0.1 0.0

        """;

    /// <summary>Two attitudes: the body's axes are those of the frame, then turned by 90 degrees about z.</summary>
    public const string Aem = """
        CCSDS_AEM_VERS = 1.0
        CREATION_DATE = 2024-01-18T00:00:00
        ORIGINATOR = TEST
        META_START
        OBJECT_NAME = ORBITER
        OBJECT_ID = 2024-001A
        REF_FRAME_A = EME2000
        REF_FRAME_B = SC_BODY_1
        ATTITUDE_DIR = A2B
        TIME_SYSTEM = UTC
        START_TIME = 2024-01-19T12:00:00.000
        STOP_TIME = 2024-01-19T12:01:00.000
        ATTITUDE_TYPE = QUATERNION
        QUATERNION_TYPE = LAST
        META_STOP
        DATA_START
        2024-01-19T12:00:00.000 0.0 0.0 0.0 1.0
        2024-01-19T12:01:00.000 0.0 0.0 0.70710678 0.70710678
        DATA_STOP

        """;

    private static readonly Lazy<TimeScale> ReadScale = new(
        () => LeapSecondsKernel.ReadScale(KernelPool.Of([Path.Combine(TestParts.Kernels, "naif0012.tls")])));

    /// <summary>The time scale of the project's leap seconds kernel.</summary>
    public static TimeScale Scale => ReadScale.Value;

    /// <summary>Noon of 2024-01-19 UTC, TDB seconds past J2000.</summary>
    public static double Noon => Scale.InstantOfMjd(60328.5).Tdb.Seconds;

    /// <summary>Reads a trajectory.</summary>
    public static IReadOnlyList<TrajectoryBlock> ReadOem(string text, List<string>? notes = null) =>
        ReadOem(Encoding.UTF8.GetBytes(text), notes);

    /// <summary>Reads a trajectory.</summary>
    public static IReadOnlyList<TrajectoryBlock> ReadOem(byte[] bytes, List<string>? notes = null) =>
        File(notes).ReadOem(new MemoryStream(bytes), "orbit.oem");

    /// <summary>Reads attitudes.</summary>
    public static IReadOnlyList<AttitudeBlock> ReadAem(string text, List<string>? notes = null, bool isRounded = false) =>
        File(notes).ReadAem(new MemoryStream(Encoding.UTF8.GetBytes(text)), "turn.aem", isRounded);

    private static CcsdsFile File(List<string>? notes) =>
        new(Scale, () => RotationMatrix.FrameAboutX(1e-3), text => notes?.Add(text));
}
