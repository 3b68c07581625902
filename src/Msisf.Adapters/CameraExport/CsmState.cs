using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes the state of USGSCSM's frame camera: the model's name, then JSON; m, s, and pixels along a row in place of mm.</summary>
internal static class CsmState
{
    /// <summary>The model's name.</summary>
    public const string Model = "USGS_ASTRO_FRAME_SENSOR_MODEL";

    /// <summary>m: heights between which the ground may lie, of any body.</summary>
    public static readonly (double Min, double Max) Heights = (-10_000.0, 25_000.0);

    /// <summary>USGSCSM has the centre of the first pixel at 0.5, this program at 1.</summary>
    public static (double Line, double Sample) Boresight(CameraModel camera) => (camera.PrincipalY - 0.5, camera.PrincipalX - 0.5);

    /// <summary>Pixels along a row, and along a column, of a length along x, and along y.</summary>
    public static (double[] Samples, double[] Lines) PixelsOf(CameraModel camera) =>
        ([0.0, 1.0, camera.Skew / camera.FocalX], [0.0, 0.0, camera.FocalY / camera.FocalX]);

    /// <summary>Writes a state.</summary>
    public static void Write(TextWriter writer, ExportedFrame frame)
    {
        CameraModel camera = frame.Camera.Model;
        CsmLens lens = CsmLens.Of(camera);
        (double[] samples, double[] lines) = PixelsOf(camera);
        (double line, double sample) = Boresight(camera);
        UnitQuaternion q = frame.BodyFromOpenCv;
        writer.WriteLine(Model);
        writer.WriteLine(Json(json =>
        {
            json.WriteString("m_modelName", Model);
            json.WriteString("m_imageIdentifier", frame.Name);
            json.WriteString("m_sensorName", "camera");
            json.WriteString("m_platformName", "msisf");
            json.WriteString("m_collectionIdentifier", string.Empty);
            json.WriteNumber("m_nLines", camera.Height);
            json.WriteNumber("m_nSamples", camera.Width);
            json.Real("m_focalLength", camera.FocalX);
            json.Real("m_focalLengthEpsilon", 0.0);
            json.Array("m_iTransS", samples);
            json.Array("m_iTransL", lines);
            json.Array("m_transX", 0.0, 1.0, -samples[2] / lines[2]);
            json.Array("m_transY", 0.0, 0.0, 1.0 / lines[2]);
            json.Array("m_ccdCenter", line, sample);
            json.Real("m_startingDetectorSample", 0.0);
            json.Real("m_startingDetectorLine", 0.0);
            json.Real("m_detectorSampleSumming", 1.0);
            json.Real("m_detectorLineSumming", 1.0);
            json.WriteNumber("m_distortionType", lens.Type);
            json.Array("m_opticalDistCoeffs", lens.Coefficients);
            json.Real("m_majorAxis", frame.Globe.ReferenceRadius);
            json.Real("m_minorAxis", frame.Globe.ReferenceRadius);
            json.Real("m_minElevation", Heights.Min);
            json.Real("m_maxElevation", Heights.Max);
            json.Real("m_ephemerisTime", frame.TdbSeconds);
            json.Array("m_currentParameterValue", [.. Of(frame.Camera.PositionBodyFixed), q.X, q.Y, q.Z, q.W]);
            json.Array("m_currentParameterCovariance", new double[49]);
            json.Array("m_spacecraftVelocity", 0.0, 0.0, 0.0);
            json.Array("m_sunPosition", Of(frame.SunPosition));
        }));
    }
}
