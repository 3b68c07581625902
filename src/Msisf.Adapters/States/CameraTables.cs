using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Scene;

namespace Msisf.Adapters.States;

/// <summary>Writes a camera and its poses as other programs have them: COLMAP's text model, EuRoC's sensor.</summary>
public static class CameraTables
{
    /// <summary>px: COLMAP counts from the upper left corner of the first pixel, whose centre is 1 here.</summary>
    private const double ColmapCenter = 0.5;

    /// <summary>px: EuRoC has the centre of the first pixel at 0, as OpenCV.</summary>
    private const double OpenCvCenter = 1.0;

    /// <summary>Whether COLMAP has a model of such a camera.</summary>
    public static bool HasColmapModel(CameraModel camera) => camera.Skew == 0.0 && ModelOf(camera.Distortion, isColmap: true) is not null;

    /// <summary>COLMAP's cameras.txt; the cameras are numbered from 1.</summary>
    /// <exception cref="BadInputException">COLMAP has no model of such a camera.</exception>
    public static void WriteColmapCameras(TextWriter writer, IReadOnlyList<CameraModel> cameras)
    {
        writer.WriteLine("# Camera list with one line of data per camera: CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]");
        writer.WriteLine("# f and c in px; the centre of the first pixel is (0.5, 0.5)");
        foreach ((int index, CameraModel camera) in cameras.Index())
        {
            (string model, double[] lens) = OfLens(camera, "COLMAP", isColmap: true);
            double[] numbers = [camera.FocalX, camera.FocalY, camera.PrincipalX - ColmapCenter, camera.PrincipalY - ColmapCenter, .. lens];
            writer.WriteLine(
                Invariant($"{index + 1} {model} {camera.Width} {camera.Height} {StateTables.Line(' ', numbers)}"));
        }
    }

    /// <summary>COLMAP's images.txt; the images are numbered from 1 through all cameras.</summary>
    /// <param name="cameras">States of each camera, and the images' names without extension.</param>
    public static void WriteColmapImages(
        TextWriter writer, IReadOnlyList<(SpacecraftState[] States, string[] Names)> cameras)
    {
        writer.WriteLine("# Image list with two lines of data per image: IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME");
        writer.WriteLine("# The quaternion (scalar first) turns the world into the camera (x right, y down, z along the line of sight).");
        writer.WriteLine("# The world is MOON_ME, m from the Moon's centre; T is the Moon's centre in the camera, m. No points.");
        int image = 0;
        foreach ((int index, (SpacecraftState[] states, string[] names)) in cameras.Index())
        {
            foreach ((SpacecraftState state, string name) in states.Zip(names))
            {
                UnitQuaternion q = StateTables.OpenCv(state).Conjugate;
                Vector3D t = default(Vector3D) - (q * state.PositionBodyFixed);
                string pose = StateTables.Line(' ', ++image, q.W, q.X, q.Y, q.Z, t.X, t.Y, t.Z);
                writer.WriteLine(Invariant($"{pose} {index + 1} {name}.png"));
                writer.WriteLine();
            }
        }
    }

    /// <summary>COLMAP's points3D.txt, without a point.</summary>
    public static void WriteColmapPoints(TextWriter writer) =>
        writer.WriteLine("# 3D point list with one line of data per point: none");

    /// <summary>EuRoC's sensor.yaml of the camera.</summary>
    /// <exception cref="BadInputException">EuRoC has no model of such a camera.</exception>
    public static void WriteEurocSensor(TextWriter writer, CameraModel camera)
    {
        (_, double[] lens) = OfLens(camera, "EuRoC", isColmap: false);
        double[] distortion = lens.Length == 0 ? [0.0, 0.0, 0.0, 0.0] : lens;
        writer.WriteLine("# The camera is the body: x right, y down, z along the line of sight. Pixel centres are whole numbers from 0.");
        writer.WriteLine("sensor_type: camera");
        writer.WriteLine($"T_BS:\n  cols: 4\n  rows: 4\n  data: [{StateTables.Identity}]");
        writer.WriteLine(Invariant($"resolution: [{camera.Width}, {camera.Height}]"));
        writer.WriteLine("camera_model: pinhole");
        writer.WriteLine(
            "intrinsics: [" + Listed(
                camera.FocalX, camera.FocalY, camera.PrincipalX - OpenCvCenter, camera.PrincipalY - OpenCvCenter) + "] # fu, fv, cu, cv");
        writer.WriteLine("distortion_model: radial-tangential");
        writer.WriteLine($"distortion_coefficients: [{Listed(distortion)}] # k1, k2, p1, p2");
    }

    private static string Listed(params double[] numbers) => StateTables.Line(',', numbers).Replace(",", ", ", StringComparison.Ordinal);

    private static (string Model, double[] Lens) OfLens(CameraModel camera, string format, bool isColmap)
    {
        if (camera.Skew != 0.0)
        {
            throw new BadInputException($"{format} has no camera with skew pixels. Set 'skew' of the camera file to 0.");
        }

        return ModelOf(camera.Distortion, isColmap) ?? throw new BadInputException(
            $"{format} has no camera with the distortion '{camera.Distortion!.Name}' of this camera file"
                + (camera.Distortion is OpenCvDistortion lens && lens.Coefficients.Skip(8).All(s => s == 0.0)
                    ? " beyond k1, k2, p1, p2"
                    : string.Empty)
                + ". Remove it, or choose another --format.");
    }

    private static (string Model, double[] Lens)? ModelOf(Distortion? lens, bool isColmap)
    {
        if (lens is null)
        {
            return ("PINHOLE", []);
        }

        double[] all = [.. lens.Coefficients]; // k1, k2, p1, p2, k3, k4, k5, k6, s1, ...
        return lens is OpenCvDistortion && all[4..].All(k => k == 0.0) ? ("OPENCV", all[..4])
            : lens is OpenCvDistortion && isColmap && all[8..].All(s => s == 0.0) ? ("FULL_OPENCV", all[..8])
            : lens is FisheyeDistortion && isColmap ? ("OPENCV_FISHEYE", all)
            : lens.Name == "radial-division" && isColmap && all[1..].All(k => k == 0.0) ? ("DIVISION", all[..1])
            : null;
    }
}
