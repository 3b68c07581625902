using System.Text.Json;
using Msisf.Core.Camera;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes image support data (ISD), as ALE does; km, s, and the lens' unit in place of mm.</summary>
internal static class AleIsd
{
    private const double MetresPerKilometre = 1000.0;

    private static readonly double[] Unturned = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];

    /// <summary>Writes it.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="isInertial">Whether positions and pointing are in J2000; otherwise in the body's axes.</param>
    public static void Write(TextWriter writer, ExportedFrame frame, bool isInertial)
    {
        CameraModel camera = frame.Camera.Model;
        CsmSensor sensor = frame.Csm?.Sensor ?? CsmSensor.Of(camera, scan: null);
        Track track = frame.Csm is null
            ? new Track([frame.TdbSeconds], [(frame.Camera.PositionBodyFixed, sensor.BodyFrom(frame.BodyFromOpenCv))])
            : Track.Of(ScanTimes.Of(frame), frame.Csm.Nodes);
        RotationMatrix[] bodyFromFrame =
            [.. track.Times.Select(time => isInertial ? frame.BodyFromJ2000At(time) : RotationMatrix.Identity)];
        UnitQuaternion[] body = ScanNodes.Continuous(bodyFromFrame.Select(UnitQuaternion.FromMatrix));
        UnitQuaternion[] pointing = ScanNodes.Continuous(track.Poses.Zip(body, (pose, turn) => pose.Turn.Conjugate * turn));
        Vector3D[] positions =
        [
            .. track.Poses.Zip(bodyFromFrame, (pose, turn) => (1.0 / MetresPerKilometre) * (turn.Transposed * pose.Position)),
        ];
        double center = frame.Csm is null ? frame.TdbSeconds : ScanTimes.Of(frame).Center;
        writer.WriteLine(Json(json =>
        {
            json.WriteString("name_model", sensor.Model);
            json.WriteString("image_identifier", frame.Name);
            json.WriteString("name_platform", "msisf");
            json.WriteString("name_sensor", "camera");
            json.Real("center_ephemeris_time", center);
            json.WriteNumber("image_lines", frame.Height);
            json.WriteNumber("image_samples", camera.Width);
            if (frame.Scan is not null)
            {
                WriteExposures(json, frame, ScanTimes.Of(frame));
            }

            json.Object("focal_length_model", () => json.Real("focal_length", sensor.FocalLength));
            json.Array("focal2pixel_lines", sensor.Lines);
            json.Array("focal2pixel_samples", sensor.Samples);
            json.Object("detector_center", () =>
            {
                json.Real("line", sensor.Line);
                json.Real("sample", sensor.Sample);
            });
            json.WriteNumber("starting_detector_line", 0);
            json.WriteNumber("starting_detector_sample", 0);
            json.WriteNumber("detector_line_summing", 1);
            json.WriteNumber("detector_sample_summing", 1);
            json.Object("optical_distortion", () => WriteLens(json, sensor.Lens));
            json.Object("radii", () =>
            {
                json.Real("semimajor", frame.Globe.ReferenceRadius / MetresPerKilometre);
                json.Real("semiminor", frame.Globe.ReferenceRadius / MetresPerKilometre);
                json.WriteString("unit", "km");
            });
            json.Object("reference_height", () =>
            {
                json.Real("minheight", CsmSensor.Heights.Min);
                json.Real("maxheight", CsmSensor.Heights.Max);
                json.WriteString("unit", "m");
            });
            WritePositions("instrument_position", track.Times, positions, hasVelocity: true);
            WriteRotations("instrument_pointing", pointing, isConstantToo: true);
            WriteRotations("body_rotation", body, isConstantToo: false);
            Vector3D sun = frame.Csm is null ? frame.SunPosition : ScanTimes.Of(frame).Sun.Position;
            RotationMatrix bodyFromSun = isInertial ? frame.BodyFromJ2000At(center) : RotationMatrix.Identity;
            WritePositions(
                "sun_position", [center], [(1.0 / MetresPerKilometre) * (bodyFromSun.Transposed * sun)], hasVelocity: false);

            void WritePositions(string name, double[] times, Vector3D[] vectors, bool hasVelocity) => json.Object(name, () =>
            {
                json.WriteString("unit", "km");
                json.WriteNumber("reference_frame", 1);
                json.Array("ephemeris_times", times);
                json.Rows("positions", vectors.Select(Of));
                if (hasVelocity)
                {
                    json.Rows("velocities", track.VelocitiesOf(vectors).Select(Of));
                }
            });

            void WriteRotations(string name, UnitQuaternion[] turns, bool isConstantToo) => json.Object(name, () =>
            {
                json.WriteNumber("reference_frame", 1);
                json.Array("ephemeris_times", track.Times);
                json.Rows("quaternions", turns.Select(q => (double[])[q.W, q.X, q.Y, q.Z]));
                json.Rows("angular_velocities", turns.Select(_ => new double[3]));
                if (isConstantToo)
                {
                    json.Array("constant_rotation", Unturned);
                }
            });
        }));
    }

    private static void WriteExposures(Utf8JsonWriter json, ExportedFrame frame, ScanTimes times)
    {
        if (frame.Scan!.Kind != ScanKind.PushFrame)
        {
            json.Real("starting_ephemeris_time", times.Start - (0.5 * frame.Scan.Period));
            json.Rows("line_scan_rate", [[0.5, times.FirstLine, times.OfLine]]);
            return;
        }

        json.Real("starting_ephemeris_time", times.Start);
        json.Real("exposure_duration", 0.0);
        json.Real("interframe_delay", frame.Scan.Period);
        json.WriteNumber("framelet_height", frame.Camera.Height);
        json.WriteBoolean("framelets_flipped", false); // as in CsmScanState
        json.WriteBoolean("framelet_order_reversed", frame.Scan.GrowsUpwards);
        json.WriteNumber("num_lines_overlap", 0);
    }

    private static void WriteLens(Utf8JsonWriter json, CsmLens lens) => json.Object(lens.Name, () =>
    {
        double[] c = lens.Coefficients;
        switch (lens.Name)
        {
            case "transverse":
                json.Array("x", c[..10]);
                json.Array("y", c[10..]);
                break;
            case "kaguyalism":
                json.Real("boresight_x", c[0]);
                json.Array("x", c[1..5]);
                json.Real("boresight_y", c[5]);
                json.Array("y", c[6..]);
                break;
            default:
                json.Array("coefficients", c);
                break;
        }
    });

    /// <summary>The poses of a camera: one of a frame, more of a scan.</summary>
    private sealed record Track(double[] Times, IReadOnlyList<(Vector3D Position, UnitQuaternion Turn)> Poses)
    {
        public static Track Of(ScanTimes times, ScanNodes nodes) => new(
            [.. Enumerable.Range(0, nodes.Poses.Count).Select(i => times.Center + (times.FirstNode + (i * times.OfNode)))], nodes.Poses);

        public Vector3D[] VelocitiesOf(Vector3D[] positions) =>
            Times.Length == 1 ? [default] : ScanTimes.Velocities(positions, (Times[^1] - Times[0]) / (Times.Length - 1));
    }
}
