using System.Text.Json;
using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// The detector and lens of a camera as USGSCSM has them; lengths of the focal plane in pixels along a row in place of mm.
/// </summary>
/// <param name="Model">Name of the camera model.</param>
/// <param name="Samples">px along a row: offset, of a length along the sensor's x, along its y.</param>
/// <param name="Lines">px along a column, the same.</param>
/// <param name="Line">px: where the boresight is, of a frame in the image, of a line-scan on its detector, of a push-frame in a framelet.
/// </param>
/// <param name="Sample">The same along a row.</param>
internal sealed record CsmSensor(string Model, CsmLens Lens, double[] Samples, double[] Lines, double Line, double Sample)
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
        (double skew, double down) = (camera.Skew / camera.FocalX, camera.FocalY / camera.FocalX);
        double[] samples = lens.IsTurned ? [0.0, -skew, 1.0] : [0.0, 1.0, skew];
        double[] lines = lens.IsTurned ? [0.0, -down, 0.0] : [0.0, 0.0, down];
        double sample = camera.PrincipalX - 0.5;
        return scan switch
        {
            null => new CsmSensor("USGS_ASTRO_FRAME_SENSOR_MODEL", lens, samples, lines, camera.PrincipalY - 0.5, sample),
            { Kind: ScanKind.PushFrame } => new CsmSensor(
                "USGS_ASTRO_PUSH_FRAME_SENSOR_MODEL", lens, samples,
                scan.FlipsFramelets ? [.. lines.Select(pixels => 0.0 - pixels)] : lines,
                scan.FlipsFramelets ? camera.Height + 0.5 - camera.PrincipalY : camera.PrincipalY - 0.5, sample),
            _ => new CsmSensor("USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL", lens, samples, lines, camera.PrincipalY - 1.0, sample),
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

/// <summary>
/// A lens as USGSCSM has it. Lengths of the focal plane are counted in pixels along a row, where USGSCSM has mm: then its inverses, which
/// end at 1e-6 of that unit, are good enough.
/// </summary>
/// <param name="Type">Number of the lens in a state.</param>
/// <param name="Name">Its name in an ISD.</param>
/// <param name="Coefficients">In the order of a state.</param>
internal sealed record CsmLens(int Type, string Name, double[] Coefficients)
{
    /// <summary>Whether it knows the sensor's y axis only, which rows then must lie along.</summary>
    public bool IsTurned => Name == "lrolrocnac";

    /// <summary>Whether USGSCSM has the camera's lens.</summary>
    public static bool Has(CameraModel camera) => Find(camera) is not null;

    /// <summary>The camera's lens, which it must have.</summary>
    public static CsmLens Of(CameraModel camera) => Find(camera)!;

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
            "radial-division" when c[1] == 0.0 && c[2] == 0.0 && camera is { Height: 1, PrincipalY: 1.0 } =>
                new CsmLens(4, "lrolrocnac", [c[0] / (f * f)]),
            "polynomial-radius" => new CsmLens(2, "kaguyalism", [0.0, .. Scaled(c.Take(4), f), 0.0, .. Scaled(c.Skip(4), f)]),
            "owen" when c[0] == 0.0 && c[2] == 0.0 && c[3] == 0.0 => new CsmLens(1, "transverse", Owen(c[1], c[4], c[5], f)),
            _ => null,
        };
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
