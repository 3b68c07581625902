using Msisf.Core.Camera;
using static Msisf.Adapters.CameraExport.ExportedNumber;

namespace Msisf.Adapters.CameraExport;

/// <summary>Writes a camera and its pose as cv::FileStorage reads them.</summary>
internal static class OpenCvCamera
{
    /// <summary>Whether OpenCV's projectPoints has the camera: it leaves skew out.</summary>
    public static bool Has(CameraModel camera) => camera.Skew == 0.0 && camera.Distortion is null or { Name: "opencv" or "fisheye" };

    /// <summary>Writes the file.</summary>
    public static void Write(TextWriter writer, ExportedFrame frame)
    {
        CameraMatrix camera = CameraMatrix.Of(frame.Camera);
        bool isFisheye = camera.Distortion is { Name: "fisheye" };
        writer.WriteLine("%YAML:1.0");
        writer.WriteLine("---");
        writer.WriteLine($"# A point X ({frame.Globe.Body.Frame}, m from the body's centre) is at R X + t in camera axes");
        writer.WriteLine("# (x right, y down, z forward); projectPoints gives its pixel, counted from 0 at the centre of the first one.");
        writer.WriteLine(Invariant($"image_width: {camera.Width}"));
        writer.WriteLine(Invariant($"image_height: {camera.Height}"));
        writer.WriteLine($"distortion_model: {(isFisheye ? "fisheye" : "opencv")}");
        WriteMatrix("camera_matrix", 3, [.. camera.IntrinsicRows.SelectMany(Of)]);
        WriteMatrix("distortion_coefficients", 1, [.. camera.Distortion?.Coefficients ?? new double[12]]);
        WriteMatrix("R", 3, [.. camera.RotationRows.SelectMany(Of)]);
        WriteMatrix("t", 3, Of(camera.Translation));

        void WriteMatrix(string name, int rows, double[] numbers) => writer.WriteLine(Invariant(
            $"{name}: !!opencv-matrix\n   rows: {rows}\n   cols: {numbers.Length / rows}\n   dt: d\n   data: [{Reals(", ", numbers)}]"));
    }
}
