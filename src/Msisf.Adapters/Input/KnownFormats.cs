using System.Buffers.Binary;
using System.Text;
using System.Text.RegularExpressions;

namespace Msisf.Adapters.Input;

/// <summary>What a file is given for.</summary>
public enum FormatUse
{
    /// <summary>A camera: <c>--camera</c>.</summary>
    Camera,

    /// <summary>Where a spacecraft is: <c>--oem</c>.</summary>
    Trajectory,

    /// <summary>States with attitudes: <c>--batch-file</c>, <c>--trajectory</c>.</summary>
    States,

    /// <summary>Craters, landmarks or points.</summary>
    List,
}

/// <summary>A format that is known, but not read where it is given; known by the file's first bytes.</summary>
/// <param name="Name">What it is, with its article.</param>
/// <param name="Is">Whether a file is of it, by its first bytes and the same as text.</param>
/// <param name="Advice">What to do, for some uses; the others have an advice of their own.</param>
public sealed record KnownFormat(
    string Name, Func<byte[], string, bool> Is, params (FormatUse Use, string Do)[] Advice)
{
    private static readonly Dictionary<FormatUse, string> Usual = new()
    {
        [FormatUse.Camera] = "Give the camera as OpenCV (YAML or XML), ROS, Kalibr or COLMAP (cameras.txt) write it, or as a camera file "
            + "(docs/cameras.md)",
        [FormatUse.Trajectory] = "Convert it to a CCSDS OEM (docs/missions.md), and give that",
        [FormatUse.States] = "Convert it to a table with the columns time, x, y, z, qx, qy, qz, qw (docs/formats.md), or give a CCSDS OEM "
            + "with --oem",
        [FormatUse.List] = "Save the list as CSV with the columns lat and lon, and diam_km for craters (docs/navigation-truth.md)",
    };

    /// <summary>Why the file is not read, and what to do.</summary>
    public string Refusal(FormatUse use) =>
        $"this is {Name}, which is not read here. {Advice.FirstOrDefault(advice => advice.Use == use).Do ?? Usual[use]}.";
}

/// <summary>The formats that are known, but not read.</summary>
public static partial class KnownFormats
{
    /// <summary>Bytes by which a format is known.</summary>
    public const int HeadBytes = 4096;

    private const string AsCamera = "Give it with --kernels, and its instrument with --instrument";

    private const string ByVectors = "Save it as CSV: ogr2ogr -f CSV list.csv FILE -lco GEOMETRY=AS_XY. Then give list.csv with --columns "
        + "lat=Y,lon=X";

    /// <summary>All of them.</summary>
    public static IReadOnlyList<KnownFormat> All { get; } =
    [
        new(
            "a file of Agisoft Metashape", (_, text) => text.Contains("<calibration>", StringComparison.Ordinal)
                || (text.Contains("<document", StringComparison.Ordinal) && text.Contains("<chunk", StringComparison.Ordinal)),
            (FormatUse.Camera, "Save the calibration in Metashape as OpenCV XML, and give that")),
        new(
            "a file of Bundler", (_, text) => text.StartsWith("# Bundle file", StringComparison.Ordinal),
            (FormatUse.Camera, "Convert it to COLMAP's text model, and give its cameras.txt")),
        new(
            "a file of VisualSFM", (_, text) => text.StartsWith("NVM_V", StringComparison.Ordinal),
            (FormatUse.Camera, "Convert it to COLMAP's text model, and give its cameras.txt")),
        new(
            "a file of OpenMVG", (_, text) => text.Contains("\"sfm_data_version\"", StringComparison.Ordinal),
            (FormatUse.Camera, "Convert it with openMVG_main_openMVG2Colmap, and give the cameras.txt")),
        new(
            "a file of transforms of NeRF", (_, text) => NerfHead().IsMatch(text),
            (FormatUse.Camera, "Give COLMAP's cameras.txt, from which it was made")),
        new(
            "COLMAP's binary model", IsColmapBinary,
            (FormatUse.Camera, "Convert it with 'colmap model_converter --output_type TXT', and give the cameras.txt")),
        new(
            "a file of Blender", (bytes, _) => Begins(bytes, "BLENDER"),
            (FormatUse.Camera, "Write a camera file with width, height, focal-length and pixel-pitch: the sensor's width over the image's, "
                + "in mm a px")),
        new(
            "a file of MATLAB", (_, text) => text.StartsWith("MATLAB 5.0 MAT-file", StringComparison.Ordinal)),
        new(
            "an SPK kernel of SPICE", (bytes, _) => Begins(bytes, "DAF/SPK"),
            (FormatUse.Trajectory, "Give it with --spk, and the spacecraft with --spacecraft"),
            (FormatUse.States, "Give it with --spk, and the spacecraft with --spacecraft"),
            (FormatUse.Camera, "It says where a spacecraft is: give it with --spk")),
        new(
            "a CK kernel of SPICE", (bytes, _) => Begins(bytes, "DAF/CK"),
            (FormatUse.Trajectory, "Give it with --ck; where the spacecraft is says an SPK: --spk"),
            (FormatUse.States, "Give it with --ck; where the spacecraft is says an SPK: --spk"),
            (FormatUse.Camera, "It says how a spacecraft points: give it with --ck")),
        new(
            "a text kernel of SPICE", (_, text) => text.StartsWith("KPL/", StringComparison.Ordinal), (FormatUse.Camera, AsCamera),
            (FormatUse.Trajectory, "Give it with --kernels; where the spacecraft is says an SPK: --spk"),
            (FormatUse.States, "Give it with --kernels; where the spacecraft is says an SPK: --spk")),
        new(
            "a PDS3 label", (_, text) => text.TrimStart().StartsWith("PDS_VERSION_ID", StringComparison.Ordinal),
            (FormatUse.Camera, "It has no camera; 'msis twin' draws what a known camera saw")),
        new(
            "a PDS4 label", (_, text) => text.Contains("<Product_Observational", StringComparison.Ordinal),
            (FormatUse.Camera, "It has no camera; 'msis twin' draws what a known camera saw")),
        new("a GPX track", (_, text) => text.Contains("<gpx", StringComparison.Ordinal)),
        new("a KML file", (_, text) => text.Contains("<kml", StringComparison.Ordinal), (FormatUse.List, ByVectors)),
        new(
            "a TLE (two-line elements)", (_, text) => TleHead().IsMatch(text),
            (FormatUse.Trajectory, "It is an orbit about the Earth, by SGP4. Convert its states to a CCSDS OEM")),
        new("an SP3 file", (_, text) => Sp3Head().IsMatch(text)),
        new(
            "an attitude file of STK", (_, text) => text.StartsWith("stk.v.", StringComparison.Ordinal)
                && text.Contains("Attitude", StringComparison.OrdinalIgnoreCase)
                && !text.Contains("BEGIN Ephemeris", StringComparison.OrdinalIgnoreCase),
            (FormatUse.Trajectory, "Give the ephemeris (.e) here, and the attitude as a CCSDS AEM with --aem")),
        new("a script of GMAT", (_, text) => GmatHead().IsMatch(text),
            (FormatUse.Trajectory, "Let an EphemerisFile of the script write a CCSDS OEM (docs/missions.md), and give that")),
        new(
            "a workbook of Excel, or another zip file", (bytes, _) => Begins(bytes, "PK\u0003\u0004"),
            (FormatUse.List, "Save the sheet as CSV")),
        new("an ESRI shapefile", (bytes, _) => bytes.AsSpan().StartsWith((byte[])[0, 0, 0x27, 0x0A]), (FormatUse.List, ByVectors)),
        new("a GeoPackage, or another database of SQLite", (bytes, _) => Begins(bytes, "SQLite format 3"), (FormatUse.List, ByVectors)),
        new(
            "a GeoJSON file",
            (_, text) => text.TrimStart() is ['{', ..] && text.Contains("\"FeatureCollection\"", StringComparison.Ordinal),
            (FormatUse.List, ByVectors)),
        new("a PNG image", (bytes, _) => Begins(bytes, "\u0089PNG")),
        new("a JPEG image", (bytes, _) => bytes.AsSpan().StartsWith((byte[])[0xFF, 0xD8, 0xFF])),
        new("a TIFF image", (bytes, _) => Begins(bytes, "II*\0") || Begins(bytes, "MM\0*")),
    ];

    /// <summary>The format of a file; null for another one.</summary>
    /// <param name="content">The file, or its first <see cref="HeadBytes"/>.</param>
    public static KnownFormat? Of(ReadOnlySpan<byte> content)
    {
        byte[] head = content[..Math.Min(content.Length, HeadBytes)].ToArray();
        string text = TextFile.Decode(head).Text;
        return All.FirstOrDefault(format => format.Is(head, text));
    }

    /// <summary>Refuses a file of a format that is known, but not read.</summary>
    /// <exception cref="BadInputException">It is of one.</exception>
    public static void Refuse(string path, FormatUse use)
    {
        if (new FileInfo(path) is not { Exists: true, Length: > 0 })
        {
            return; // a pipe, which can be read once only
        }

        byte[] head = new byte[HeadBytes];
        int count = FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            return stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        });
        if (Of(head.AsSpan(0, count)) is { } known)
        {
            throw new BadInputException($"{path}: {known.Refusal(use)}");
        }
    }

    private static bool Begins(byte[] bytes, string with) => bytes.AsSpan().StartsWith(Encoding.Latin1.GetBytes(with));

    /// <summary>A count, then id, model and size of the first camera.</summary>
    private static bool IsColmapBinary(byte[] bytes, string text) => bytes.Length >= 32
        && BinaryPrimitives.ReadUInt64LittleEndian(bytes) is > 0 and < 1_000_000
        && BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(12)) < 32
        && BinaryPrimitives.ReadUInt64LittleEndian(bytes.AsSpan(16)) is > 0 and < 1_000_000
        && BinaryPrimitives.ReadUInt64LittleEndian(bytes.AsSpan(24)) is > 0 and < 1_000_000;

    [GeneratedRegex(@"\A\s*\{[\s\S]*""(?:camera_angle_x|fl_x|transform_matrix)""")]
    private static partial Regex NerfHead();

    [GeneratedRegex(@"(?m)^1 [ \dA-Z]{5}[A-Z ] .{50,}\r?\n2 [ \dA-Z]{5} ")]
    private static partial Regex TleHead();

    [GeneratedRegex(@"\A#[a-d][PV]\d{4} ")]
    private static partial Regex Sp3Head();

    [GeneratedRegex(@"(?m)^\s*(?:%General Mission Analysis Tool|Create (?:Spacecraft|Propagator|EphemerisFile) )")]
    private static partial Regex GmatHead();
}
