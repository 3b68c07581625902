using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

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
