using Msisf.Core.Camera;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes a camera and its pose as the pinhole file (.tsai) of the Ames Stereo Pipeline; lengths of the image in pixels.</summary>
internal static class TsaiCamera
{
    private static readonly string[] OfOpenCv = ["k1", "k2", "p1", "p2", "k3"];

    private static readonly string[] OfRadial = ["xp", "yp", "k1", "k2", "k3", "p1", "p2", "phi"];

    private static readonly string[] OfFisheye = ["k1", "k2", "k3", "k4"];

    /// <summary>Whether the pipeline has the camera.</summary>
    public static bool Has(CameraModel camera) => camera.Skew == 0.0
        && (camera.Distortion is null or { Name: "fisheye" }
            || (camera.Distortion is { Name: "radial-factor" } && camera.FocalX == camera.FocalY) // its radius is counted in pixels
            || camera.Distortion is { Name: "opencv" } lens && lens.Coefficients.Skip(OfOpenCv.Length).All(k => k == 0.0));

    /// <summary>Writes the file.</summary>
    public static void Write(TextWriter writer, ExportedFrame frame)
    {
        CameraMatrix camera = CameraMatrix.Of(frame.Camera);
        RotationMatrix turned = camera.Rotation.Transposed;
        writer.WriteLine("VERSION_4");
        writer.WriteLine("PINHOLE");
        writer.WriteLine($"fu = {Real(camera.FocalLength)}");
        writer.WriteLine($"fv = {Real(camera.FocalLengthDown)}");
        writer.WriteLine($"cu = {Real(camera.PrincipalX)}");
        writer.WriteLine($"cv = {Real(camera.PrincipalY)}");
        writer.WriteLine("u_direction = 1 0 0");
        writer.WriteLine("v_direction = 0 1 0");
        writer.WriteLine("w_direction = 0 0 1");
        writer.WriteLine($"C = {Reals(" ", Of(frame.Camera.PositionBodyFixed))}");
        writer.WriteLine($"R = {Reals(" ", [.. Of(turned.Row0), .. Of(turned.Row1), .. Of(turned.Row2)])}");
        writer.WriteLine("pitch = 1");
        if (camera.Distortion is not { } lens)
        {
            writer.WriteLine("NULL");
            return;
        }

        (string model, string[] names, IEnumerable<double> values) = lens.Name switch
        {
            "fisheye" => ("FISHEYE", OfFisheye, lens.Coefficients),
            "radial-factor" => ("BROWNCONRADY", OfRadial, InPixels(lens.Coefficients, camera.FocalLength)),
            _ => ("TSAI", OfOpenCv, lens.Coefficients),
        };
        writer.WriteLine(model);
        foreach ((string name, double value) in names.Zip(values))
        {
            writer.WriteLine($"{name} = {Real(value)}");
        }
    }

    /// <summary>Its own principal point, the factor, and a decentring that is none.</summary>
    private static IEnumerable<double> InPixels(IReadOnlyList<double> k, double focal) =>
        [0.0, 0.0, .. k.Select((value, i) => value / Math.Pow(focal, 2 * (i + 1))), 0.0, 0.0, 0.0];
}
