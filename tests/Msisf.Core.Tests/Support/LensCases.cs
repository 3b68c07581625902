using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Tests.Support;

/// <summary>Cameras of every distortion model, as strong as a lens can be, for any field of view.</summary>
internal static class LensCases
{
    public static IReadOnlyList<string> Names { get; } =
    [
        "principal-point", "barrel", "pincushion", "rational", "prism", "owen", "fisheye", "radial-factor", "radial-division", "polynomial",
        "polynomial-of-x", "brown",
    ];

    /// <summary>A camera.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <param name="tangent">Tangent of half the field of view along rows, about.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public static CameraModel Of(string name, double tangent, int width, int height)
    {
        double t = tangent;
        double t2 = t * t;
        double focal = 0.5 * width / t;
        (double X, double Y) middle = (0.5 * (width + 1), 0.5 * (height + 1));
        CameraModel With(Distortion? distortion, double x = 0.03, double y = -0.04) => new(
            width, height, (focal, focal), (middle.X + (x * width), middle.Y + (y * height)), 0.0, distortion);
        double angle = Math.Atan(1.3 * t);
        return name switch
        {
            "principal-point" => new CameraModel(
                width, height, (focal, 1.25 * focal), (middle.X + (0.4 * width), middle.Y - (0.7 * height)), 0.05 * focal),
            "barrel" => With(new OpenCvDistortion([-0.05 / t2], [])),
            "pincushion" => With(new OpenCvDistortion([0.15 / t2, 0.01 / (t2 * t2)], [0.01 / t, -0.02 / t])),
            "rational" => With(new OpenCvDistortion(
                [0.30 / t2, 0.1 / (t2 * t2), 0.02 / (t2 * t2 * t2), 0.25 / t2, 0.05 / (t2 * t2), 0.01 / (t2 * t2 * t2)], [])),
            "prism" => With(new OpenCvDistortion(
                [-0.02 / t2], [0.005 / t, 0.01 / t], [0.02 / t, -0.002 / (t * t2), -0.03 / t, 0.001 / (t * t2)])),
            "owen" => With(new OwenDistortion(
                [0.01 / t, 0.05 / t2, 0.002 / (t * t2), -0.004 / (t2 * t2), 0.01 / t, -0.015 / t], 1.0)),
            "fisheye" => new CameraModel(
                width, height, (0.5 * width / angle, 0.5 * width / angle), middle, 0.0,
                new FisheyeDistortion([0.02, -0.005, 0.001, -0.0002])),
            "radial-factor" => With(new RadialDistortion([0.12 / t2, 0.01 / (t2 * t2), 0.001 / (t2 * t2 * t2)], isDivision: false, 1.0)),
            "radial-division" => With(new RadialDistortion([0.08 / t2], isDivision: true, 1.0)),
            "brown" => With(new BrownDistortion(
                [0.01, 0.05 / t2, 0.01 / (t2 * t2), 0.001 / (t2 * t2 * t2)], [0.01 / t, -0.015 / t],
                [0.01 / t, -0.002 / (t * t2), -0.01 / t, 0.001 / (t * t2)], (0.05 * t, -0.1 * t), 1.0)),
            "polynomial" => With(new PolynomialDistortion(
                [-0.01 * t, 0.02, 0.01 / t, -0.005 / t2], [0.02 * t, -0.01, 0.02 / t, 0.002 / t2], isRadial: true, 1.0)),
            "polynomial-of-x" => With(new PolynomialDistortion(
                [-0.01 * t, 0.02, 0.01 / t, -0.005 / t2], [0.02 * t, -0.01, 0.02 / t, 0.002 / t2], isRadial: false, 1.0)),
            _ => throw new ArgumentOutOfRangeException(nameof(name)),
        };
    }
}
