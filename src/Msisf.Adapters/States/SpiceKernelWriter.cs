using Msisf.Core.Camera;

namespace Msisf.Adapters.States;

/// <summary>
/// Writes states as SPICE kernels: an SPK of type 13, a CK of type 3, and the text kernels that they need: clock (SCLK), frame (FK) and
/// instrument (IK).
/// </summary>
/// <remarks>NAIF, SPK, CK, SCLK and Frames Required Reading.</remarks>
/// <param name="head">One line about the files, ASCII.</param>
/// <param name="states">In the order of time, at least one.</param>
public sealed class SpiceKernelWriter(string head, IReadOnlyList<InertialState> states)
{
    /// <summary>The spacecraft's number, which no mission has.</summary>
    public const int Spacecraft = -999;

    /// <summary>The number of the camera and of its frame.</summary>
    public const int Instrument = -999001;

    /// <summary>Name of the camera and of its frame.</summary>
    public const string CameraName = "MSISF_CAMERA";

    /// <summary>Name of the spacecraft.</summary>
    public const string SpacecraftName = "MSISF";

    private const int Moon = 301;
    private const int J2000 = 1;
    private const int SpkType = 13;
    private const int CkType = 3;
    private const int DirectoryStep = 100;
    private const int WindowSize = 4; // Hermite of degree 7
    private const double TicksPerSecond = 1e6;
    private const double Padding = 1.0; // s: how far the kernels reach beyond the states, for whoever asks a little outside
    private const double KilometresPerMetre = 1e-3;
    private const double PitchMillimetres = 0.01; // any: the camera is known in pixels, and only the quotient counts

    /// <summary>TDB: the clock's zero, a whole second before the first state.</summary>
    private readonly double _clockZero = Math.Floor(states[0].TdbSeconds) - 10.0;

    /// <summary>The SPK. What lies beyond the states is a segment of its own, so that it bends no polynomial between them.</summary>
    public void WriteSpk(Stream stream)
    {
        InertialState[] padded = Padded();
        InertialState[][] segments = states.Count == 1 ? [padded] : [padded[..2], padded[^2..], padded[1..^1]]; // the last one wins
        DafWriter.Write(
            stream, "DAF/SPK", Comments("J2000, about the Moon (301); km, km/s; TDB"), [.. segments.Select(SpkSegment)]);
    }

    /// <summary>The CK.</summary>
    public void WriteCk(Stream stream)
    {
        InertialState[] all = Padded();
        bool hasRates = all[0].RateJ2000 is not null;
        double[] ticks = [.. all.Select(state => (state.TdbSeconds - _clockZero) * TicksPerSecond)];
        List<double> data = [];
        foreach (InertialState state in all)
        {
            UnitQuaternion q = (state.J2000FromCamera * StateTables.CameraFromOpenCv).Conjugate;
            data.AddRange([q.W, q.X, q.Y, q.Z, .. hasRates ? StateTables.Numbers(state.RateJ2000!.Value) : []]);
        }

        data.AddRange([.. ticks, .. Directory(ticks), ticks[0], 1.0, ticks.Length]); // one interval, that begins with the first record
        string rates = hasRates ? "angular velocities rad/s along J2000" : "no angular velocities";
        DafWriter.Write(
            stream, "DAF/CK", Comments($"J2000 to {CameraName}; quaternions scalar first, as SPICE has them (M2Q); {rates}"),
            [new DafSegment(ticks[0], ticks[^1], [Instrument, J2000, CkType, hasRates ? 1 : 0], [.. data])]);
    }

    private static DafSegment SpkSegment(InertialState[] part)
    {
        List<double> data = [];
        foreach (InertialState state in part)
        {
            data.AddRange(StateTables.Numbers(KilometresPerMetre * state.State.Position));
            data.AddRange(StateTables.Numbers(KilometresPerMetre * state.State.Velocity));
        }

        double[] epochs = [.. part.Select(state => state.TdbSeconds)];
        data.AddRange([.. epochs, .. Directory(epochs), Math.Min(WindowSize, part.Length) - 1.0, part.Length]);
        return new DafSegment(epochs[0], epochs[^1], [Spacecraft, Moon, J2000, SpkType], [.. data]);
    }

    /// <summary>The clock: microseconds since <see cref="_clockZero"/>, in TDB.</summary>
    public void WriteClock(TextWriter writer) => Write(writer, "SCLK", Invariant($$"""
        SCLK_KERNEL_ID             = ( @2024-01-01 )
        SCLK_DATA_TYPE_999         = ( 1 )
        SCLK01_TIME_SYSTEM_999     = ( 1 )
        SCLK01_N_FIELDS_999        = ( 2 )
        SCLK01_MODULI_999          = ( 10000000000 1000000 )
        SCLK01_OFFSETS_999         = ( 0 0 )
        SCLK01_OUTPUT_DELIM_999    = ( 1 )
        SCLK_PARTITION_START_999   = ( 0.0 )
        SCLK_PARTITION_END_999     = ( 1.0E15 )
        SCLK01_COEFFICIENTS_999    = ( 0.0 {{_clockZero:R}} 1.0 )
        """));

    /// <summary>The frame of the camera, whose orientation the CK has.</summary>
    public void WriteFrame(TextWriter writer) => Write(writer, "FK", Invariant($$"""
        NAIF_BODY_NAME            += ( '{{SpacecraftName}}' '{{CameraName}}' )
        NAIF_BODY_CODE            += ( {{Spacecraft}} {{Instrument}} )
        FRAME_{{CameraName}}         = {{Instrument}}
        FRAME_{{Instrument}}_NAME     = '{{CameraName}}'
        FRAME_{{Instrument}}_CLASS    = 3
        FRAME_{{Instrument}}_CLASS_ID = {{Instrument}}
        FRAME_{{Instrument}}_CENTER   = {{Spacecraft}}
        CK_{{Instrument}}_SCLK        = {{Spacecraft}}
        CK_{{Instrument}}_SPK         = {{Spacecraft}}
        """));

    /// <summary>The camera: its field of view, and the numbers of its pixels. A lens is left out, and the file says so.</summary>
    public void WriteInstrument(TextWriter writer, CameraModel camera)
    {
        double focal = camera.FocalX * PitchMillimetres;
        double pitchY = focal / camera.FocalY;
        double skew = camera.Skew / focal; // px a mm down
        (double left, double top) = (0.5 - camera.PrincipalX, 0.5 - camera.PrincipalY);
        string[] corners =
        [
            .. new[] { (0, 0), (1, 0), (1, 1), (0, 1) }.Select(corner =>
            {
                double down = (top + (corner.Item2 * camera.Height)) * pitchY;
                return StateTables.Line(
                    ' ', (left + (corner.Item1 * camera.Width) - (skew * down)) * PitchMillimetres, down, focal);
            }),
        ];

        // One number is the pitch of square pixels only; of others ITRANSS and ITRANSL have both.
        string pitch = pitchY == PitchMillimetres
            ? Invariant($"INS{Instrument}_PIXEL_PITCH          = ( {PitchMillimetres:R} )\n")
            : string.Empty;
        Write(writer, "IK", Invariant($$"""
            INS{{Instrument}}_FOV_FRAME            = '{{CameraName}}'
            INS{{Instrument}}_FOV_SHAPE            = 'POLYGON'
            INS{{Instrument}}_BORESIGHT            = ( 0.0 0.0 {{focal:R}} )
            INS{{Instrument}}_FOV_CLASS_SPEC       = 'CORNERS'
            INS{{Instrument}}_FOV_BOUNDARY_CORNERS = ( {{string.Join("\n    ", corners)}} )
            INS{{Instrument}}_FOCAL_LENGTH         = ( {{focal:R}} )
            {{pitch}}INS{{Instrument}}_PIXEL_SAMPLES        = ( {{camera.Width}} )
            INS{{Instrument}}_PIXEL_LINES          = ( {{camera.Height}} )
            INS{{Instrument}}_CCD_CENTER           = ( {{camera.PrincipalX:R}} {{camera.PrincipalY:R}} )
            INS{{Instrument}}_ITRANSS              = ( 0.0 {{1.0 / PitchMillimetres:R}} {{skew:R}} )
            INS{{Instrument}}_ITRANSL              = ( 0.0 0.0 {{1.0 / pitchY:R}} )
            """), LensLeftOut(camera));
    }

    /// <summary>What is to be said of a lens, which the kernels do not have; null for none.</summary>
    public static string? LensLeftOut(CameraModel camera) => camera.Distortion is { IsNone: false } lens
        ? $"the camera's lens ({lens.Name}) is left out: the instrument kernel describes a camera without distortion"
        : null;

    private static double[] Directory(double[] values) =>
        [.. Enumerable.Range(1, (values.Length - 1) / DirectoryStep).Select(i => values[(i * DirectoryStep) - 1])];

    /// <summary>The states, and one a second before and after them, on straight lines and turning at the rates there.</summary>
    private InertialState[] Padded()
    {
        bool hasRates = states.All(state => state.RateJ2000 is not null);
        return [.. new[] { Moved(states[0], -Padding) }.Concat(states).Append(Moved(states[^1], Padding))
            .Select(state => hasRates ? state : state with { RateJ2000 = null })];
    }

    private static InertialState Moved(InertialState state, double seconds)
    {
        Vector3D rate = state.RateJ2000 ?? default;
        return state with
        {
            TdbSeconds = state.TdbSeconds + seconds,
            State = state.State with { Position = state.State.Position + (seconds * state.State.Velocity) },
            J2000FromCamera = rate == default
                ? state.J2000FromCamera
                : UnitQuaternion.FromAxisAngle(rate, seconds * rate.Length) * state.J2000FromCamera,
        };
    }

    private string[] Comments(string content) =>
    [
        head, content, $"{CameraName}: x right in the image, y down, z along the line of sight",
        "padded by 1 s at either end, on a straight line with the velocity there",
        .. states.Count > 1 ? (string[])[] : ["one state alone: its velocity is 0 where nothing says it"],
    ];

    private void Write(TextWriter writer, string kind, string assignments, string? note = null)
    {
        writer.WriteLine($"KPL/{kind}");
        writer.WriteLine();
        string content = kind == "SCLK" ? "ticks of a microsecond, in TDB" : "lengths in mm, counted with a pitch of 0.01";
        foreach (string line in Comments(content).Concat(note is null ? [] : [note]))
        {
            writer.WriteLine(line);
        }

        writer.WriteLine();
        writer.WriteLine("\\begindata");
        writer.WriteLine();
        writer.WriteLine(assignments);
        writer.WriteLine();
        writer.WriteLine("\\begintext");
    }
}
