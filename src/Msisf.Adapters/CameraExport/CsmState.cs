using Msisf.Core.Camera;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes the state of USGSCSM's camera: the model's name, then JSON; m, s, and pixels along a row in place of mm.</summary>
internal static class CsmState
{
    public static void Write(TextWriter writer, ExportedFrame frame)
    {
        if (frame.Scan is not null)
        {
            CsmScanState.Write(writer, frame);
            return;
        }

        CameraModel camera = frame.Camera.Model;
        CsmSensor sensor = CsmSensor.Of(camera, scan: null);
        UnitQuaternion q = sensor.BodyFrom(frame.BodyFromOpenCv);
        (double[] s, double[] l) = (sensor.Samples, sensor.Lines);
        double determinant = (s[1] * l[2]) - (s[2] * l[1]);
        writer.WriteLine(sensor.Model);
        writer.WriteLine(Json(json =>
        {
            json.WriteString("m_modelName", sensor.Model);
            json.WriteString("m_imageIdentifier", frame.Name);
            json.WriteString("m_sensorName", "camera");
            json.WriteString("m_platformName", "msisf");
            json.WriteString("m_collectionIdentifier", string.Empty);
            json.WriteNumber("m_nLines", camera.Height);
            json.WriteNumber("m_nSamples", camera.Width);
            json.Real("m_focalLength", camera.FocalX);
            json.Real("m_focalLengthEpsilon", 0.0);
            json.Array("m_iTransS", s);
            json.Array("m_iTransL", l);
            json.Array("m_transX", 0.0, l[2] / determinant, 0.0 - (s[2] / determinant));
            json.Array("m_transY", 0.0, 0.0 - (l[1] / determinant), s[1] / determinant);
            json.Array("m_ccdCenter", sensor.Line, sensor.Sample);
            sensor.Write(json, frame.Globe.ReferenceRadius);
            json.Real("m_ephemerisTime", frame.TdbSeconds);
            json.Array("m_currentParameterValue", [.. Of(frame.Camera.PositionBodyFixed), q.X, q.Y, q.Z, q.W]);
            json.Array("m_currentParameterCovariance", new double[49]);
            json.Array("m_spacecraftVelocity", 0.0, 0.0, 0.0);
            json.Array("m_sunPosition", Of(frame.SunPosition));
        }));
    }
}
