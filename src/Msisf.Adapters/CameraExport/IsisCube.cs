using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
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
    private const int Frame = States.SpiceKernelWriter.Instrument;

    private const int Sun = 10;
    private const double KilometresPerMetre = 1e-3;

    /// <summary>The special pixel NULL of real numbers: no data.</summary>
    private static readonly float Null = BitConverter.UInt32BitsToSingle(0xFF7FFFFB);

    private static readonly string[] Position = ["J2000X", "J2000Y", "J2000Z", "ET"];

    private static readonly string[] State = ["J2000X", "J2000Y", "J2000Z", "J2000XV", "J2000YV", "J2000ZV", "ET"];

    private static readonly string[] Rotation = ["J2000Q0", "J2000Q1", "J2000Q2", "J2000Q3", "ET"];

    /// <summary>Whether IdealCamera has the camera: it has no distortion.</summary>
    public static bool Has(CameraModel camera) => camera.Distortion is null;

    /// <summary>Writes a cube.</summary>
    public static void Write(Stream stream, ExportedFrame frame)
    {
        ExportedImage image = frame.Image!;
        Table[] tables = [.. TablesOf(frame)];
        byte[] label = new byte[LabelBytes];
        Encoding.ASCII.GetBytes(Label(frame, image, tables), label);
        stream.Write(label);
        image.WritePixels(stream, Null);
        foreach (Table table in tables)
        {
            stream.Write(MemoryMarshal.AsBytes(table.Values.AsSpan()));
        }
    }

    private static IEnumerable<Table> TablesOf(ExportedFrame frame)
    {
        double time = frame.TdbSeconds;
        RotationMatrix fromBody = frame.BodyFromJ2000.Transposed;
        UnitQuaternion body = UnitQuaternion.FromMatrix(frame.BodyFromJ2000);
        UnitQuaternion pointing = frame.BodyFromOpenCv.Conjugate * body;
        StateVector sun = frame.Ephemeris!.StateOf(Sun, time);
        yield return Turning("InstrumentPointing", Frame, pointing);
        yield return Moving("InstrumentPosition", Position, [.. Km(fromBody * frame.Camera.PositionBodyFixed), time]);
        yield return Turning("BodyRotation", FrameOf(frame.Globe.Body), body);
        yield return Moving("SunPosition", State, [.. Km(fromBody * frame.SunPosition), .. Km(sun.Velocity), time]);

        Table Moving(string name, string[] fields, double[] values) => new(name, "CacheType = Linear", "Spk", fields, time, values);

        Table Turning(string name, int number, UnitQuaternion q) => new(
            name, $"TimeDependentFrames = ({number}, 1)", "Ck", Rotation, time, [q.W, q.X, q.Y, q.Z, time]);

        double[] Km(Vector3D v) => Of(KilometresPerMetre * v);
    }

    private static string Label(ExportedFrame frame, ExportedImage image, Table[] tables)
    {
        CameraModel camera = frame.Camera.Model;
        string time = frame.Time.ToIsoUtc().TrimEnd('Z');
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
                StartTime            = {time}
                StopTime             = {time}
                EphemerisTime        = {Real(frame.TdbSeconds)} <seconds>
                InstrumentType       = Framing
                SampleDetectors      = {image.Width}
                LineDetectors        = {image.Height}
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
        long start = LabelBytes + 1L + ((long)sizeof(float) * image.Width * image.Height);
        foreach (Table table in tables)
        {
            table.WriteTo(text, start);
            start += sizeof(double) * table.Values.Length;
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

    /// <summary>A table of one record.</summary>
    /// <param name="Name">Name.</param>
    /// <param name="Keyword">A line of its label.</param>
    /// <param name="Kernel">The kind of kernel that such a table replaces, as keywords begin.</param>
    /// <param name="Fields">Names of the columns.</param>
    /// <param name="Time">TDB seconds past J2000.</param>
    /// <param name="Values">A number for each column.</param>
    private sealed record Table(string Name, string Keyword, string Kernel, string[] Fields, double Time, double[] Values)
    {
        public void WriteTo(StringBuilder text, long start)
        {
            text.Append(CultureInfo.InvariantCulture, $"""

                Object = Table
                  Name = {Name}
                  StartByte = {start}
                  Bytes = {sizeof(double) * Values.Length}
                  Records = 1
                  ByteOrder = Lsb
                  {Keyword}
                  {Kernel}TableStartTime = {Real(Time)}
                  {Kernel}TableEndTime = {Real(Time)}
                  {Kernel}TableOriginalSize = 1

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
