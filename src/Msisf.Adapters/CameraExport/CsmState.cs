using System.Text.Json;
using Msisf.Core.Camera;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes the state of USGSCSM's camera: the model's name, then JSON; m, s, and the lens' unit in place of mm.</summary>
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
            json.Real("m_focalLength", sensor.FocalLength);
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

/// <summary>
/// Writes the state of USGSCSM's line-scan or push-frame camera: the model's name, then JSON; m, s, and the lens' unit in place of mm.
/// </summary>
internal static class CsmScanState
{
    /// <summary>Numbers by which these models can be adjusted.</summary>
    private const int Parameters = 16;

    public static void Write(TextWriter writer, ExportedFrame frame)
    {
        (ExportedScan scan, CsmScan csm) = (frame.Scan!, frame.Csm!);
        CsmSensor sensor = csm.Sensor;
        ScanTimes times = ScanTimes.Of(frame);
        writer.WriteLine(sensor.Model);
        writer.WriteLine(Json(json =>
        {
            json.WriteString("m_modelName", sensor.Model);
            json.WriteString("m_imageIdentifier", frame.Name);
            json.WriteString("m_sensorName", "camera");
            json.WriteString("m_sensorIdentifier", "camera");
            json.WriteString("m_platformName", "msisf");
            json.WriteString("m_platformIdentifier", "msisf");
            json.WriteNumber("m_platformFlag", 1);
            json.WriteNumber("m_ikCode", 0);
            json.WriteNumber("m_nLines", frame.Height);
            json.WriteNumber("m_nSamples", frame.Camera.Width);
            if (scan.Kind == ScanKind.PushFrame)
            {
                WriteFramelets(json, frame, scan);
                json.Real("m_startingEphemerisTime", times.Start);
            }
            else
            {
                json.Array("m_intTimeLines", 0.5);
                json.Array("m_intTimeStartTimes", times.FirstLine);
                json.Array("m_intTimes", times.OfLine);
                json.Real("m_startingEphemerisTime", times.Start - (0.5 * scan.Period));
            }

            json.Real("m_centerEphemerisTime", times.Center);
            json.Real("m_focalLength", sensor.FocalLength);
            json.Real("m_zDirection", 1.0);
            json.Array("m_iTransS", sensor.Samples);
            json.Array("m_iTransL", sensor.Lines);
            json.Real("m_detectorSampleOrigin", sensor.Sample);
            json.Real("m_detectorLineOrigin", sensor.Line);
            sensor.Write(json, frame.Globe.ReferenceRadius);
            WriteMotion(json, csm.Nodes.Poses, times);
            json.Array("m_currentParameterValue", new double[Parameters]);
            json.WriteStartArray("m_parameterType");
            for (int i = 0; i < Parameters; i++)
            {
                json.WriteStringValue("REAL");
            }

            json.WriteEndArray();
            json.Array("m_referencePointXyz", 0.0, 0.0, 0.0);
            (Vector3D sun, Vector3D velocity) = times.Sun;
            json.Array("m_sunPosition", Of(sun));
            json.Array("m_sunVelocity", Of(velocity));

            // With these two USGSCSM computes them and the next two, the reference point and the covariance.
            json.Real("m_gsd", 1.0);
            json.Real("m_flyingHeight", 1000.0);
            json.Real("m_halfSwath", 1000.0);
            json.Real("m_halfTime", 10.0);
            json.Array("m_covariance", new double[Parameters * Parameters]);
        }));
    }

    private static void WriteFramelets(Utf8JsonWriter json, ExportedFrame frame, ExportedScan scan)
    {
        json.Real("m_exposureDuration", 0.0); // half of it is added to the times, which are those of the middle
        json.Real("m_interframeDelay", scan.Period);
        json.WriteNumber("m_frameletHeight", frame.Camera.Height);
        json.WriteBoolean("m_frameletsFlipped", false); // USGSCSM reads it one way only; the sign in m_iTransL says it both ways
        json.WriteBoolean("m_frameletsOrderReversed", scan.GrowsUpwards);
        json.WriteNumber("m_numLinesOverlap", 0);
        json.WriteNumber("m_reducedframeletHeight", frame.Camera.Height);
        json.WriteNumber("m_nReducedLines", frame.Height);
    }

    private static void WriteMotion(
        Utf8JsonWriter json, IReadOnlyList<(Vector3D Position, UnitQuaternion Turn)> poses, ScanTimes times)
    {
        json.Real("m_t0Ephem", times.FirstNode);
        json.Real("m_dtEphem", times.OfNode);
        json.WriteNumber("m_numPositions", 3 * poses.Count);
        json.Array("m_positions", poses.SelectMany(pose => Of(pose.Position)));
        json.Array("m_velocities", ScanTimes.Velocities([.. poses.Select(pose => pose.Position)], times.OfNode).SelectMany(Of));
        json.Real("m_t0Quat", times.FirstNode);
        json.Real("m_dtQuat", times.OfNode);
        json.WriteNumber("m_numQuaternions", 4 * poses.Count);
        json.Array("m_quaternions", poses.SelectMany(pose => (double[])[pose.Turn.X, pose.Turn.Y, pose.Turn.Z, pose.Turn.W]));
    }
}
