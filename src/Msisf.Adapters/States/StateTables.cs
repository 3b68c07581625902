using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Adapters.States;

/// <summary>Writes states as tables: CSV, TUM, EuRoC.</summary>
public static class StateTables
{
    /// <summary>Says in each file what its quaternion turns.</summary>
    private const string CameraAxesText = "camera axes (x right in the image, y down, z along the line of sight)";

    private static readonly CalendarTime UnixZero = CalendarTime.Of(new DateOnly(1970, 1, 1), 0m);

    /// <summary>Columns that --batch-file reads back, to the last bit.</summary>
    public static void WriteCsv(TextWriter writer, IReadOnlyList<SpacecraftState> states)
    {
        bool hasMotion = states.All(state => state.Motion is not null);
        writer.WriteLine("# msis: frame=moon-me axes=camera rotation=from-camera");
        writer.WriteLine(
            "# time: MJD, UTC; x, y, z: m from the Moon's centre along MOON_ME; qx, qy, qz, qw (scalar last) turn camera axes (looks along "
                + "-x, y right, z up) into MOON_ME" + (hasMotion ? "; v: m/s over the Moon; w: rad/s about camera axes" : string.Empty));
        writer.WriteLine("time,x,y,z,qx,qy,qz,qw" + (hasMotion ? $",{string.Join(',', CameraMotion.NumberNames)}" : string.Empty));
        foreach (SpacecraftState state in states)
        {
            writer.WriteLine(Line(',', (hasMotion ? state : state with { Motion = null }).ToNumbers()));
        }
    }

    /// <summary>The trajectory format of TUM's RGB-D benchmark.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="numbers">Numbers of images, which stand for their times; null for the times.</param>
    public static void WriteTum(TextWriter writer, IReadOnlyList<SpacecraftState> states, IReadOnlyList<int>? numbers = null)
    {
        string timestamp = numbers is null ? "s since 1970-01-01 UTC" : "the number of the image";
        writer.WriteLine(
            $"# timestamp tx ty tz qx qy qz qw (scalar last): {timestamp}; m from the Moon's centre along MOON_ME; turns "
                + $"{CameraAxesText} into MOON_ME");
        foreach ((SpacecraftState state, int index) in states.Select((state, index) => (state, index)))
        {
            UnitQuaternion q = OpenCv(state);
            string stamp = numbers is null ? UnixSeconds(state.Time) : TimestampOf(numbers[index]);
            writer.WriteLine(
                $"{stamp} {Line(' ', [.. Numbers(state.PositionBodyFixed), q.X, q.Y, q.Z, q.W])}");
        }
    }

    /// <summary>The number of an image in the place of a time.</summary>
    public static string TimestampOf(int number) => number.ToString("0.000000", CultureInfo.InvariantCulture);

    /// <summary>The states of EuRoC's ground truth; with velocities only where they are known.</summary>
    public static void WriteEurocStates(TextWriter writer, IReadOnlyList<SpacecraftState> states)
    {
        bool hasMotion = states.All(state => state.Motion is not null);
        writer.WriteLine(
            "#timestamp [ns since 1970-01-01 UTC],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []"
                + (hasMotion ? ",v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1]" : string.Empty));
        foreach (SpacecraftState state in states)
        {
            UnitQuaternion q = OpenCv(state);
            double[] velocity = hasMotion ? Numbers(state.Motion!.Value.VelocityBodyFixed) : [];
            writer.WriteLine(
                $"{UnixNanoseconds(state.Time)},{Line(',', [.. Numbers(state.PositionBodyFixed), q.W, q.X, q.Y, q.Z, .. velocity])}");
        }
    }

    /// <summary>The list of EuRoC's images.</summary>
    public static void WriteEurocImages(TextWriter writer, IReadOnlyList<SpacecraftState> states, IReadOnlyList<string> names)
    {
        writer.WriteLine("#timestamp [ns since 1970-01-01 UTC],filename");
        for (int i = 0; i < states.Count; i++)
        {
            writer.WriteLine($"{UnixNanoseconds(states[i].Time)},{names[i]}.png");
        }
    }

    /// <summary>What the states of EuRoC are, which its tables have no place for.</summary>
    public static string EurocStatesYaml =>
        $"# R is MOON_ME, m from the Moon's centre; S is the {CameraAxesText}.\n"
        + "# q_RS (scalar first) turns S into R; velocities are over the turning Moon, along R.\n"
        + $"sensor_type: visual-inertial\ncomment: states of msis\nT_BS:\n  cols: 4\n  rows: 4\n  data: [{Identity}]\n";

    /// <summary>The camera axes of OpenCV in MOON_ME.</summary>
    internal static UnitQuaternion OpenCv(SpacecraftState state) => state.MoonFromCamera * CameraFromOpenCv;

    /// <summary>The elements of a matrix that changes nothing.</summary>
    internal const string Identity = "1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1";

    /// <summary>OpenCV's x is the camera's y, its y the camera's -z, its z the camera's -x.</summary>
    internal static UnitQuaternion CameraFromOpenCv { get; } = UnitQuaternion.FromMatrix(
        new RotationMatrix(new Vector3D(0.0, 0.0, -1.0), Vector3D.UnitX, new Vector3D(0.0, -1.0, 0.0)));

    /// <summary>Numbers to their last bit.</summary>
    internal static string Line(char separator, params double[] numbers) =>
        string.Join(separator, numbers.Select(number => number.ToString("R", CultureInfo.InvariantCulture)));

    /// <summary>The three numbers of a vector.</summary>
    internal static double[] Numbers(Vector3D v) => [v.X, v.Y, v.Z];

    /// <summary>A time as CCSDS has it, to the nanosecond: 2024-01-19T12:00:00.000000000.</summary>
    internal static string Calendar(Instant time) => time.Utc.ToNanoseconds();

    private static string UnixSeconds(Instant time) => UnixTime(time).ToString("F9", CultureInfo.InvariantCulture);

    private static string UnixNanoseconds(Instant time) =>
        (UnixTime(time) * 1_000_000_000m).ToString("F0", CultureInfo.InvariantCulture);

    /// <summary>Unix counts 86 400 s in each day, so that a leap second has the numbers of the second after it.</summary>
    private static decimal UnixTime(Instant time) => (time.Utc - UnixZero).ToDecimalSeconds(decimals: 9);
}
