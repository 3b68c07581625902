using System.Text.Json;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes the image support data (ISD) of a frame camera, as ALE does; km, s, and pixels along a row in place of mm.</summary>
internal static class AleIsd
{
    private const double MetresPerKilometre = 1000.0;

    private static readonly double[] Unturned = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];

    /// <summary>Writes it.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="isInertial">Whether positions and pointing are in J2000; otherwise in the body's axes.</param>
    public static void Write(TextWriter writer, ExportedFrame frame, bool isInertial)
    {
        CameraModel camera = frame.Camera.Model;
        RotationMatrix bodyFromFrame = isInertial ? frame.BodyFromJ2000 : RotationMatrix.Identity;
        UnitQuaternion body = UnitQuaternion.FromMatrix(bodyFromFrame);
        UnitQuaternion pointing = frame.BodyFromOpenCv.Conjugate * body;
        double time = frame.TdbSeconds;
        (double[] samples, double[] lines) = CsmState.PixelsOf(camera);
        (double line, double sample) = CsmState.Boresight(camera);
        writer.WriteLine(Json(json =>
        {
            json.WriteString("name_model", CsmState.Model);
            json.WriteString("image_identifier", frame.Name);
            json.WriteString("name_platform", "msisf");
            json.WriteString("name_sensor", "camera");
            json.Real("center_ephemeris_time", time);
            json.WriteNumber("image_lines", camera.Height);
            json.WriteNumber("image_samples", camera.Width);
            json.Object("focal_length_model", () => json.Real("focal_length", camera.FocalX));
            json.Array("focal2pixel_lines", lines);
            json.Array("focal2pixel_samples", samples);
            json.Object("detector_center", () =>
            {
                json.Real("line", line);
                json.Real("sample", sample);
            });
            json.WriteNumber("starting_detector_line", 0);
            json.WriteNumber("starting_detector_sample", 0);
            json.WriteNumber("detector_line_summing", 1);
            json.WriteNumber("detector_sample_summing", 1);
            json.Object("optical_distortion", () => WriteLens(json, CsmLens.Of(camera)));
            json.Object("radii", () =>
            {
                json.Real("semimajor", frame.Globe.ReferenceRadius / MetresPerKilometre);
                json.Real("semiminor", frame.Globe.ReferenceRadius / MetresPerKilometre);
                json.WriteString("unit", "km");
            });
            json.Object("reference_height", () =>
            {
                json.Real("minheight", CsmState.Heights.Min);
                json.Real("maxheight", CsmState.Heights.Max);
                json.WriteString("unit", "m");
            });
            Vector("instrument_position", frame.Camera.PositionBodyFixed, hasVelocity: true);
            Rotation("instrument_pointing", pointing, isConstantToo: true);
            Rotation("body_rotation", body, isConstantToo: false);
            Vector("sun_position", frame.SunPosition, hasVelocity: false);

            void Vector(string name, Vector3D inBody, bool hasVelocity) => json.Object(name, () =>
            {
                json.WriteString("unit", "km");
                json.WriteNumber("reference_frame", 1);
                json.Array("ephemeris_times", time);
                json.Row("positions", Of((1.0 / MetresPerKilometre) * (bodyFromFrame.Transposed * inBody)));
                if (hasVelocity)
                {
                    json.Row("velocities", 0.0, 0.0, 0.0);
                }
            });

            void Rotation(string name, UnitQuaternion q, bool isConstantToo) => json.Object(name, () =>
            {
                json.WriteNumber("reference_frame", 1);
                json.Array("ephemeris_times", time);
                json.Row("quaternions", q.W, q.X, q.Y, q.Z);
                json.Row("angular_velocities", 0.0, 0.0, 0.0);
                if (isConstantToo)
                {
                    json.Array("constant_rotation", Unturned);
                }
            });
        }));
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
}
