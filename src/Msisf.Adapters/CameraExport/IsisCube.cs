using System.Runtime.InteropServices;
using System.Text;
using Msisf.Adapters.States;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// Writes a cube of ISIS: the image as its one band, with the camera as IdealCamera and the tables that spiceinit attaches. Lengths of the
/// focal plane are in pixels along a row, where ISIS has mm; the others are in km.
/// </summary>
/// <remarks>
/// IdealCamera.cpp, CameraFocalPlaneMap.cpp, Spice.cpp, SpicePosition.cpp and SpiceRotation.cpp of ISIS. With the object NaifKeywords in
/// the label no kernel is read; IDEAL_TRANSX to IDEAL_TRANSL in it can say any affine map from the focal plane to pixels.
/// </remarks>
internal static class IsisCube
{
    /// <summary>Bytes of the label, filled up with zeros; what ISIS takes itself.</summary>
    private const int LabelBytes = 65536;

    /// <summary>NAIF's number of the camera's frame, which no mission has.</summary>
    private const int Frame = SpiceKernelWriter.Instrument;

    private const int Sun = 10;
    private const double KilometresPerMetre = 1e-3;

    /// <summary>The special pixel NULL of real numbers: no data.</summary>
    private static readonly float Null = BitConverter.UInt32BitsToSingle(0xFF7FFFFB);

    private static readonly string[] Position = ["J2000X", "J2000Y", "J2000Z", "ET"];

    private static readonly string[] State = ["J2000X", "J2000Y", "J2000Z", "J2000XV", "J2000YV", "J2000ZV", "ET"];

    private static readonly string[] Rotation = ["J2000Q0", "J2000Q1", "J2000Q2", "J2000Q3", "ET"];

    /// <summary>Whether IdealCamera has the camera: it has no distortion.</summary>
    public static bool Has(CameraModel camera) => camera.Distortion is null;

    /// <summary>Writes a cube. The lines of a scan are in the order of their times.</summary>
    public static void Write(Stream stream, ExportedFrame frame)
    {
        ExportedImage image = frame.Image!;
        Table[] tables = [.. TablesOf(frame)];
        byte[] label = new byte[LabelBytes];
        Encoding.ASCII.GetBytes(Label(frame, image, tables), label);
        stream.Write(label);
        image.WritePixels(stream, Null, isFromFoot: ScanOf(frame) is { GrowsUpwards: true });
        foreach (Table table in tables)
        {
            stream.Write(MemoryMarshal.AsBytes(table.Values.AsSpan()));
        }
    }

    /// <summary>A line-scan; null for a frame, also for one whose rows a shutter exposed at times of their own.</summary>
    private static ExportedScan? ScanOf(ExportedFrame frame) => frame.Scan is { Kind: ScanKind.LineScan } scan ? scan : null;

    /// <summary>A record for each exposure, which ISIS takes as it is at the middle of a line.</summary>
    private static IEnumerable<Table> TablesOf(ExportedFrame frame)
    {
        double atImage = frame.TdbSeconds;
        IReadOnlyList<CameraState> states = ScanOf(frame)?.States ?? [frame.Camera.State with { Seconds = 0.0 }];
        double[] times = [.. states.Select(state => atImage + state.Seconds)];
        RotationMatrix[] body = [.. times.Select(frame.BodyFromJ2000At)];
        UnitQuaternion[] turns = [.. body.Select(UnitQuaternion.FromMatrix)];
        IEnumerable<UnitQuaternion> pointing = states.Zip(turns, (state, turn) =>
            (state.MoonFromCamera * StateTables.CameraFromOpenCv).Conjugate * turn);
        StateVector sun = frame.Ephemeris!.StateOf(Sun, atImage);
        Vector3D sunAtImage = frame.BodyFromJ2000.Transposed * frame.SunPosition;
        yield return Turning("InstrumentPointing", Frame, pointing);
        yield return Moving(
            "InstrumentPosition", Position, times, states.Zip(body, (state, turn) => Km(turn.Transposed * state.PositionBodyFixed)));
        yield return Turning("BodyRotation", FrameOf(frame.Globe.Body), turns);
        double[] ends = times.Length == 1 ? times : [times[0], times[^1]];
        yield return Moving("SunPosition", State, ends, ends.Select(
            time => (double[])[.. Km(sunAtImage + ((time - atImage) * sun.Velocity)), .. Km(sun.Velocity)]));

        static Table Moving(string name, string[] fields, double[] times, IEnumerable<double[]> places) => new(
            name, "CacheType = Linear", "Spk", fields, times,
            [.. places.Zip(times, (place, time) => (double[])[.. place, time]).SelectMany(record => record)]);

        Table Turning(string name, int number, IEnumerable<UnitQuaternion> turned) => new(
            name, $"TimeDependentFrames = ({number}, 1)", "Ck", Rotation, times,
            [.. turned.Zip(times, (q, time) => (double[])[q.W, q.X, q.Y, q.Z, time]).SelectMany(record => record)]);

        static double[] Km(Vector3D v) => Of(KilometresPerMetre * v);
    }

    private static string Label(ExportedFrame frame, ExportedImage image, Table[] tables)
    {
        CameraModel camera = frame.Camera.Model;
        string start = frame.Time.ToIsoUtc().TrimEnd('Z');
        string stop = start;
        string type = "Framing";
        string more = string.Empty;
        double time = frame.TdbSeconds;
        if (ScanOf(frame) is { } scan)
        {
            // As of all line-scan cubes, from the beginning of the first line to the end of the last one.
            start = frame.Time.After(scan.FirstSeconds - (0.5 * scan.Period)).ToIsoUtc().TrimEnd('Z');
            stop = frame.Time.After(scan.FirstSeconds + ((scan.Count - 0.5) * scan.Period)).ToIsoUtc().TrimEnd('Z');
            type = "Linescan";
            more = $"\n    ExposureDuration     = {Real(1000.0 * scan.Period)} <milliseconds>";
            time += scan.FirstSeconds - (0.5 * scan.Period);
        }

        StringBuilder text = new();
        text.Append(CultureInfo.InvariantCulture, $"""
            Object = IsisCube
              Object = Core
                StartByte = {LabelBytes + 1}
                Format    = BandSequential

                Group = Dimensions
                  Samples = {image.Width}
                  Lines   = {image.Height}
                  Bands   = 1
                End_Group

                Group = Pixels
                  Type       = Real
                  ByteOrder  = Lsb
                  Base       = 0.0
                  Multiplier = 1.0
                End_Group
              End_Object

              Group = Instrument
                SpacecraftName       = IdealSpacecraft
                InstrumentId         = IdealCamera
                TargetName           = {frame.Globe.Body.Name}
                StartTime            = {start}
                StopTime             = {stop}
                EphemerisTime        = {Real(time)} <seconds>
                InstrumentType       = {type}{more}
                SampleDetectors      = {camera.Width}
                LineDetectors        = {camera.Height}
                FocalPlaneXDependency = 1
              End_Group

              Group = Radiometry
                RadiometricType = {(image.IsDigital ? "DN" : "IOF")}
              End_Group

              Group = Kernels
                NaifFrameCode      = {Frame}
                TargetPosition     = Table
                InstrumentPosition = Table
                InstrumentPointing = Table
                ShapeModel         = Null
                CameraVersion      = 1
              End_Group
            End_Object

            Object = Label
              Bytes = {LabelBytes}
            End_Object

            """);
        long place = LabelBytes + 1L + ((long)sizeof(float) * image.Width * image.Height);
        foreach (Table table in tables)
        {
            table.WriteTo(text, place);
            place += sizeof(double) * table.Values.Length;
        }

        (double[] x, double[] y, double[] samples, double[] lines) = AffineOf(camera);
        string radius = Real(KilometresPerMetre * frame.Globe.ReferenceRadius);
        text.Append(CultureInfo.InvariantCulture, $"""

            Object = NaifKeywords
              BODY_CODE          = {frame.Globe.Body.NaifNumber}
              BODY{frame.Globe.Body.NaifNumber}_RADII      = ({radius}, {radius}, {radius})
              BODY_FRAME_CODE    = {FrameOf(frame.Globe.Body)}
              IDEAL_FOCAL_LENGTH = {Real(camera.FocalX)}
              IDEAL_PIXEL_PITCH  = 1.0
              IDEAL_TRANSX       = ({Reals(", ", x)})
              IDEAL_TRANSY       = ({Reals(", ", y)})
              IDEAL_TRANSS       = ({Reals(", ", samples)})
              IDEAL_TRANSL       = ({Reals(", ", lines)})
            End_Object
            End

            """);
        return text.ToString().ReplaceLineEndings("\n");
    }

    /// <summary>
    /// The focal plane's x and y of pixels from the detector's middle, and such pixels of x and y: each a constant and two factors.
    /// </summary>
    private static (double[] X, double[] Y, double[] Samples, double[] Lines) AffineOf(CameraModel camera)
    {
        double sample = camera.PrincipalX - (0.5 * (camera.Width + 1));
        double line = camera.PrincipalY - (0.5 * (camera.Height + 1));
        double skew = camera.Skew / camera.FocalX;
        double down = camera.FocalY / camera.FocalX;
        return (
            [(skew * line / down) - sample, 1.0, -skew / down],
            [-line / down, 0.0, 1.0 / down],
            [sample, 1.0, skew],
            [line, 0.0, down]);
    }

    /// <summary>NAIF's number of the body's frame; of MOON_ME that of the frame kernels moon_080317.tf and later.</summary>
    private static int FrameOf(CelestialBody body) => body.NaifNumber switch
    {
        199 => 10011,
        299 => 10012,
        499 => 10014,
        501 => 10023,
        502 => 10024,
        503 => 10025,
        504 => 10026,
        _ => 31001,
    };

    /// <summary>A table.</summary>
    /// <param name="Keyword">A line of its label.</param>
    /// <param name="Kernel">The kind of kernel that such a table replaces, as keywords begin.</param>
    /// <param name="Fields">Names of the columns.</param>
    /// <param name="Times">TDB seconds past J2000, of each record.</param>
    /// <param name="Values">A number for each column, record by record.</param>
    private sealed record Table(string Name, string Keyword, string Kernel, string[] Fields, double[] Times, double[] Values)
    {
        public void WriteTo(StringBuilder text, long start)
        {
            text.Append(CultureInfo.InvariantCulture, $"""

                Object = Table
                  Name = {Name}
                  StartByte = {start}
                  Bytes = {sizeof(double) * Values.Length}
                  Records = {Times.Length}
                  ByteOrder = Lsb
                  {Keyword}
                  {Kernel}TableStartTime = {Real(Times[0])}
                  {Kernel}TableEndTime = {Real(Times[^1])}
                  {Kernel}TableOriginalSize = {Times.Length}

                """);
            foreach (string field in Fields)
            {
                text.Append(CultureInfo.InvariantCulture, $"""

                      Group = Field
                        Name = {field}
                        Type = Double
                        Size = 1
                      End_Group

                    """);
            }

            text.Append("End_Object\n");
        }
    }
}
