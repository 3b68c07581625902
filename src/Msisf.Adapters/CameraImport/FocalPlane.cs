using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraImport;

/// <summary>
/// A detector as USGS has it: pixels of a point of the focal plane are a constant and two factors of its x and y (mm), from a centre.
/// </summary>
/// <param name="Program">Whose file it is.</param>
/// <param name="Path">For messages.</param>
/// <param name="FocalLength">mm.</param>
/// <param name="Samples">px: a constant, a mm of x, a mm of y, along a row.</param>
/// <param name="Lines">px: the same along a column.</param>
/// <param name="Center">px: the sample and line from which these count; the centre of the first pixel is (0.5, 0.5).</param>
internal sealed record FocalPlane(
    string Program, string Path, double FocalLength, double[] Samples, double[] Lines, (double Sample, double Line) Center)
{
    /// <summary>1: a turn of the detector by less is none.</summary>
    private const double NoTurn = 1e-12;

    /// <summary>px.</summary>
    public required (int Width, int Height) Size { get; init; }

    /// <summary>What scans; null for a frame.</summary>
    public ScanKind? Scan { get; init; }

    /// <summary>s from a line or framelet to the next; negative where the image grows upwards.</summary>
    public double Period { get; init; }

    /// <summary>Type of the lens, as USGSCSM's states count them.</summary>
    public int LensType { get; init; }

    /// <summary>Its coefficients, in USGSCSM's order.</summary>
    public double[] Coefficients { get; init; } = [];

    /// <summary>The camera, whose axes are x right, y down: the detector may be turned about the line of sight.</summary>
    /// <exception cref="BadInputException">It is mirrored, or its lens has no counterpart.</exception>
    public ImportedCamera Camera()
    {
        (double a, double b) = (Samples[1], Samples[2]);
        (double c, double d) = (Lines[1], Lines[2]);
        double determinant = (a * d) - (b * c);
        bool isFlipped = determinant < 0.0 && Scan is ScanKind.LineScan or ScanKind.PushFrame;
        if (isFlipped)
        {
            (c, d) = (-c, -d); // a scan whose rows lie the other way round on the detector
        }

        if (determinant == 0.0 || (determinant < 0.0 && !isFlipped))
        {
            throw Wrong("the image is mirrored, or a line, by its factors from mm to pixels. Give the camera as a camera file");
        }

        double down = double.Hypot(c, d);
        (double x, double y) right = (d / down, -c / down); // the row's direction in the focal plane
        double acrossRight = (right.x * a) + (right.y * b);
        double acrossDown = ((c / down) * a) + ((d / down) * b);
        bool isTurned = Math.Abs(right.y) > NoTurn || right.x < 0.0;
        double scale = LensType == 0 && Coefficients.Length > 0 ? 1.0 - Coefficients[0] : 1.0;
        double line = Center.Line + Lines[0];
        return new ImportedCamera(Program, 1)
        {
            Size = Size,
            Focal = (FocalLength / scale * acrossRight, FocalLength / scale * down),
            Principal = (Center.Sample + Samples[0], isFlipped ? Size.Height - line : line),
            Convention = "colmap",
            Skew = Math.Abs(acrossDown) > NoTurn * acrossRight ? FocalLength / scale * acrossDown : 0.0,
            LensUnits = FocalLength / scale,
            Lens = Lens(right, isTurned, scale, Math.Abs(line - (0.5 * Size.Height))),
            Scan = ScanKeys(isFlipped),
        };
    }

    private IReadOnlyList<(string, double[], string)> ScanKeys(bool isFlipped) => Scan switch
    {
        ScanKind.LineScan =>
        [
            ImportedCamera.Key("kind", "line-scan"), ImportedCamera.Key("period", Math.Abs(Period)),
            ImportedCamera.Key("order", Period < 0.0 ? "up" : "down"),
        ],
        ScanKind.PushFrame =>
        [
            ImportedCamera.Key("kind", "push-frame"), ImportedCamera.Key("period", Math.Abs(Period)),
            ImportedCamera.Key("order", Period < 0.0 ? "up" : "down"), ImportedCamera.Key("flip", isFlipped ? "yes" : "no"),
        ],
        _ => [],
    };

    /// <summary>USGSCSM's lenses; x and y in mm, measured from the boresight (docs/cameras.md).</summary>
    private IReadOnlyList<(string, double[], string)> Lens((double X, double Y) right, bool isTurned, double scale, double rowOff)
    {
        double[] k = Coefficients;
        if (k.All(coefficient => coefficient == 0.0))
        {
            return [];
        }

        const double onAxis = 1e-9; // px: a row through the boresight
        (string Name, IReadOnlyList<(string, double[], string)>? Keys) lens = (LensType, k.Length, isTurned) switch
        {
            (0, 3, _) => ("RADIAL", k[1] == 0.0 && k[2] == 0.0 ? [] : Radial("factor", -k[1] / scale, -k[2] / scale)),
            (1, 20, false) => ("TRANSVERSE", Owen(k)),
            (2, 10, _) => ("KAGUYALISM", Kaguya(right, [k[0] + k[1], .. k[2..5]], [k[5] + k[6], .. k[7..]])),
            (4, 1, true) => (
                "LROLROCNAC", Math.Abs(right.X) < NoTurn && Size.Height == 1 && rowOff < onAxis ? Radial("division", k[0]) : null),
            (7, 5, _) => (
                "RADTAN",
                ImportedCamera.OpenCv(k[0], k[1], (right.X * k[2]) - (right.Y * k[3]), (right.X * k[3]) + (right.Y * k[2]), k[4])),
            _ => ($"of type {LensType} with {k.Length} coefficients{(isTurned ? " on a turned detector" : string.Empty)}", null),
        };
        return lens.Keys ?? throw Wrong(
            $"the lens {lens.Name} has no counterpart in msis with these numbers. Give the camera as a camera file (docs/cameras.md)");
    }

    /// <summary>Polynomials of the distance, which a turn mixes as it mixes x and y.</summary>
    private static IReadOnlyList<(string, double[], string)> Kaguya((double X, double Y) right, double[] x, double[] y) =>
    [
        ImportedCamera.Key("model", "polynomial"), ImportedCamera.Key("argument", "radius"),
        ImportedCamera.Key("x", [.. x.Zip(y, (a, b) => (right.X * a) + (right.Y * b))]),
        ImportedCamera.Key("y", [.. x.Zip(y, (a, b) => (right.X * b) - (right.Y * a))]),
    ];

    private static IReadOnlyList<(string, double[], string)> Radial(string form, params double[] k) =>
        [ImportedCamera.Key("model", "radial"), ImportedCamera.Key("form", form), ImportedCamera.Key("k", k)];

    /// <summary>Cubics for x and y that are Owen's with e2, e5 and e6; null for others.</summary>
    private static IReadOnlyList<(string, double[], string)>? Owen(double[] k)
    {
        (double cubic, double byY, double byX) = (k[6], k[4], k[3]);
        double[] same =
        [
            0.0, 1.0, 0.0, byX, byY, 0.0, cubic, 0.0, cubic, 0.0,
            0.0, 0.0, 1.0, 0.0, byX, byY, 0.0, cubic, 0.0, cubic,
        ];
        return !k.SequenceEqual(same) ? null
            : cubic == 0.0 && byX == 0.0 && byY == 0.0 ? []
            : [
                ImportedCamera.Key("model", "owen"), ImportedCamera.Key("e2", cubic), ImportedCamera.Key("e5", byY),
                ImportedCamera.Key("e6", byX),
            ];
    }

    private BadInputException Wrong(string why) => new($"{Path}: {why}.");
}
