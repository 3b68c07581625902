using System.Text.Json;
using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>The detector and lens of a camera as USGSCSM has them; lengths of the focal plane are in the unit of the lens.</summary>
/// <param name="Model">Name of the camera model.</param>
/// <param name="FocalLength">In the unit of the lens.</param>
/// <param name="Samples">px along a row: offset, of a length along the sensor's x, along its y.</param>
/// <param name="Lines">px along a column, the same.</param>
/// <param name="Line">px: where the zero of the focal plane is, of a frame in the image, of a line-scan on its detector, of a push-frame
/// in a framelet.</param>
/// <param name="Sample">The same along a row.</param>
internal sealed record CsmSensor(
    string Model, CsmLens Lens, double FocalLength, double[] Samples, double[] Lines, double Line, double Sample)
{
    /// <summary>m: heights between which the ground may lie, of any body.</summary>
    public static readonly (double Min, double Max) Heights = (-10_000.0, 25_000.0);

    /// <summary>Turns the sensor's axes into OpenCV's, from which they differ where the lens knows one axis only.</summary>
    private static readonly UnitQuaternion OpenCvFromTurned = UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, -Math.PI / 2.0);

    /// <summary>The sensor of an image. USGSCSM has the centre of the first pixel at 0.5, this program at 1.</summary>
    /// <param name="camera">The camera, of a scan that of one exposure.</param>
    /// <param name="scan">How it scans; null for a frame.</param>
    public static CsmSensor Of(CameraModel camera, ExportedScan? scan)
    {
        CsmLens lens = CsmLens.Of(camera);
        (double perSample, double skew, double down) = (1.0 / lens.Pitch, camera.Skew / camera.FocalX, camera.FocalY / camera.FocalX);
        double[] samples = lens.IsTurned ? [0.0, -skew * perSample, perSample] : [0.0, perSample, skew * perSample];
        double[] lines = lens.IsTurned ? [0.0, -down * perSample, 0.0] : [0.0, 0.0, down * perSample];
        double sample = camera.PrincipalX - 0.5 + (lens.Zero.X + (skew * lens.Zero.Y));
        double zero = camera.PrincipalY + (down * lens.Zero.Y);
        double focalLength = camera.FocalX * lens.Pitch;
        return scan switch
        {
            null => new CsmSensor("USGS_ASTRO_FRAME_SENSOR_MODEL", lens, focalLength, samples, lines, zero - 0.5, sample),
            { Kind: ScanKind.PushFrame } => new CsmSensor(
                "USGS_ASTRO_PUSH_FRAME_SENSOR_MODEL", lens, focalLength, samples,
                scan.FlipsFramelets ? [.. lines.Select(pixels => 0.0 - pixels)] : lines,
                scan.FlipsFramelets ? camera.Height + 0.5 - zero : zero - 0.5, sample),
            _ => new CsmSensor("USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL", lens, focalLength, samples, lines, zero - 1.0, sample),
        };
    }

    /// <summary>Turns the sensor's axes into the body's.</summary>
    /// <param name="bodyFromOpenCv">Turns OpenCV's camera axes (x right, y down, z forward) there.</param>
    public UnitQuaternion BodyFrom(UnitQuaternion bodyFromOpenCv) =>
        Lens.IsTurned ? bodyFromOpenCv * OpenCvFromTurned : bodyFromOpenCv;

    /// <summary>Writes what the states of all models say of the detector, the lens and the body.</summary>
    /// <param name="json">The state.</param>
    /// <param name="referenceRadius">m.</param>
    public void Write(Utf8JsonWriter json, double referenceRadius)
    {
        json.Real("m_startingDetectorSample", 0.0);
        json.Real("m_startingDetectorLine", 0.0);
        json.Real("m_detectorSampleSumming", 1.0);
        json.Real("m_detectorLineSumming", 1.0);
        json.WriteNumber("m_distortionType", Lens.Type);
        json.Array("m_opticalDistCoeffs", Lens.Coefficients);
        json.Real("m_majorAxis", referenceRadius);
        json.Real("m_minorAxis", referenceRadius);
        json.Real("m_minElevation", Heights.Min);
        json.Real("m_maxElevation", Heights.Max);
    }
}

/// <summary>A lens as USGSCSM has it.</summary>
/// <param name="Type">Number of the lens in a state.</param>
/// <param name="Name">Its name in an ISD.</param>
/// <param name="Coefficients">In the order of a state.</param>
/// <remarks>
/// Lengths of the focal plane are counted in pixels along a row, where USGSCSM has mm: then its inverses, which end at 1e-6 of that unit,
/// are good enough. LROLROCNAC alone needs mm: USGSCSM leaves it out where an ideal point is more than 40 from the axis.
/// </remarks>
internal sealed record CsmLens(int Type, string Name, double[] Coefficients)
{
    /// <summary>Pixel pitch of LROC's narrow angle cameras, whose lens is LROLROCNAC, mm.</summary>
    private const double NacPitch = 0.007;

    /// <summary>mm: half the distance from which on USGSCSM takes a point for one outside the image, and leaves LROLROCNAC out.</summary>
    private const double NacReach = 20.0;

    /// <summary>Lengths of the unit in a pixel along a row.</summary>
    public double Pitch { get; init; } = 1.0;

    /// <summary>px along a row: the zero of the focal plane, from the principal point.</summary>
    public (double X, double Y) Zero { get; init; }

    /// <summary>px: how far it is from the camera's lens somewhere in the image; 0 for the same lens.</summary>
    public double Misfit { get; init; }

    /// <summary>Whether it knows the sensor's y axis only, which rows then must lie along.</summary>
    public bool IsTurned => Name == "lrolrocnac";

    /// <summary>Whether USGSCSM has the camera's lens, or one that is near enough.</summary>
    public static bool Has(CameraModel camera) => Nearest(camera) is { Misfit: <= CsmLensFit.Limit };

    /// <summary>The camera's lens, or the nearest one, which it must have.</summary>
    public static CsmLens Of(CameraModel camera) => Nearest(camera)!;

    /// <summary>What USGSCSM lacks of a camera's lens, and how near its nearest lens is; null if it has the same lens.</summary>
    public static string? Difference(CameraModel camera) => Nearest(camera) switch
    {
        null => $"USGSCSM has no counterpart of {Missing(camera)}",
        { Misfit: > 0.0 } nearest => $"USGSCSM has no counterpart of {Missing(camera)}; "
            + Invariant($"its {nearest.Name.ToUpperInvariant()} is off by up to {nearest.Misfit:G2} px"),
        _ => null,
    };

    /// <summary>For lenses of instrument kernels the nearest one will do.</summary>
    private static CsmLens? Nearest(CameraModel camera) => Find(camera)
        ?? (camera.Distortion is { Name: "radial-factor" or "polynomial-x" or "brown" } ? CsmLensFit.Of(camera) : null);

    /// <summary>The part of a camera's lens that USGSCSM lacks.</summary>
    private static string Missing(CameraModel camera) => camera.Distortion!.Name switch
    {
        "opencv" => "k4 to k6 and s1 to s4",
        "radial-factor" => "k3 (its RADIAL ends with the fourth power)",
        "radial-division" when camera.Distortion.Coefficients.Skip(1).Any(k => k != 0.0) => "k2 and k3",
        "radial-division" => "a division in an image that is not one row through the axis",
        "polynomial-x" => "a polynomial of x in an image of several rows",
        "owen" => "e1, e3 and e4",
        "brown" => "corrections about a centre of their own, along a direction and of the sixth power",
        string name => $"the model '{name}'",
    };

    private static CsmLens? Find(CameraModel camera)
    {
        double f = camera.FocalX;
        if (camera.Distortion is not { } lens)
        {
            return new CsmLens(0, "radial", [0.0, 0.0, 0.0]);
        }

        IReadOnlyList<double> c = lens.Coefficients;
        return lens.Name switch
        {
            "opencv" when c.Skip(5).All(k => k == 0.0) => new CsmLens(7, "radtan", [.. c.Take(5)]),
            "radial-factor" when c[2] == 0.0 => new CsmLens(0, "radial", [0.0, -c[0] / (f * f), -c[1] / (f * f * f * f)]),
            "radial-division" when c[1] == 0.0 && c[2] == 0.0 && camera is { Height: 1, PrincipalY: 1.0 } => Division(camera, c[0]),
            "polynomial-radius" => new CsmLens(2, "kaguyalism", [0.0, .. Scaled(c.Take(4), f), 0.0, .. Scaled(c.Skip(4), f)]),
            "polynomial-x" when camera.Height == 1 => AlongRow(camera, [.. Scaled(c.Take(4), f)], [.. Scaled(c.Skip(4), f)]),
            "owen" when c[0] == 0.0 && c[2] == 0.0 && c[3] == 0.0 => new CsmLens(1, "transverse", Owen(c[1], c[4], c[5], f)),
            "brown" when c.Skip(3).All(k => k == 0.0) => new CsmLens(0, "radial", [-c[0], -c[1] / (f * f), -c[2] / (f * f * f * f)]),
            _ => null,
        };
    }

    /// <summary>A lens in mm. Its pixels are smaller than LROC's if the row would otherwise not be near enough.</summary>
    private static CsmLens Division(CameraModel camera, double k)
    {
        double end = camera.FocalX
            * Math.Max(Math.Abs(camera.ToIdeal(1.0, 1.0).Right), Math.Abs(camera.ToIdeal(camera.Width, 1.0).Right));
        double pitch = Math.Min(NacPitch, NacReach / end);
        return new CsmLens(4, "lrolrocnac", [k / (camera.FocalX * camera.FocalX * pitch * pitch)]) { Pitch = pitch };
    }

    /// <summary>
    /// A lens of one row. KAGUYALISM's polynomials are of the distance from a zero in the row, left of all its pixels.
    /// </summary>
    /// <param name="x">px along a row that are added to it, by powers of the distance from the principal point.</param>
    /// <param name="y">px that are added across it.</param>
    public static CsmLens AlongRow(CameraModel camera, double[] x, double[] y)
    {
        double zeroY = (1.0 - camera.PrincipalY) * camera.FocalX / camera.FocalY;
        double first = 1.0 - camera.PrincipalX - (camera.Skew / camera.FocalX * zeroY);
        double zeroX = first - camera.Width;
        (double[] alongX, double[] alongY) = (From(x), From(y));
        return new CsmLens(2, "kaguyalism", [zeroX, .. alongX, zeroY, .. alongY]) { Zero = (zeroX, zeroY) };

        // The polynomial of the distance from the zero.
        double[] From(double[] a) =>
        [
            a[0] + (zeroX * (a[1] + (zeroX * (a[2] + (zeroX * a[3]))))),
            a[1] + (zeroX * ((2.0 * a[2]) + (3.0 * zeroX * a[3]))),
            a[2] + (3.0 * zeroX * a[3]),
            a[3],
        ];
    }

    /// <summary>Coefficients by increasing power.</summary>
    private static IEnumerable<double> Scaled(IEnumerable<double> coefficients, double f) =>
        coefficients.Select((coefficient, power) => coefficient * Math.Pow(f, 1 - power));

    /// <summary>Cubics for x and for y: 1, x, y, xx, xy, yy, xxx, xxy, xyy, yyy.</summary>
    private static double[] Owen(double e2, double e5, double e6, double f)
    {
        (double cubic, double byY, double byX) = (e2 / (f * f), e5 / f, e6 / f);
        return
        [
            0.0, 1.0, 0.0, byX, byY, 0.0, cubic, 0.0, cubic, 0.0,
            0.0, 0.0, 1.0, 0.0, byX, byY, 0.0, cubic, 0.0, cubic,
        ];
    }
}
