using Msisf.Core.Attitude;

namespace Msisf.Adapters.Camera;

/// <summary>How the pixels of an instrument lie in its focal plane, whose x and y (mm) are those of its lens.</summary>
/// <param name="Right">Along a row, length 1.</param>
/// <param name="Down">Along a column; perpendicular to <paramref name="Right"/>.</param>
/// <param name="SamplesRight">px a mm: samples along <paramref name="Right"/>.</param>
/// <param name="SamplesDown">px a mm: samples along <paramref name="Down"/>.</param>
/// <param name="LinesDown">px a mm: lines along <paramref name="Down"/>.</param>
/// <param name="Constant">px: what ITRANSS and ITRANSL add to the pixel of the axis.</param>
/// <remarks>ISIS's CameraFocalPlaneMap: sample = ITRANSS[0] + ITRANSS[1] x + ITRANSS[2] y from the pixel of the axis on.</remarks>
internal sealed record FocalPlane(
    Vector3D Right, Vector3D Down, double SamplesRight, double SamplesDown, double LinesDown, (double Sample, double Line) Constant)
{
    /// <summary>1: by how much the pitch may differ from ITRANSS or ITRANSL, rounded as they are.</summary>
    private const double PitchDigits = 1e-5;

    /// <summary>1: by how much TRANSX and TRANSY, rounded as they are, may differ from the inverse of ITRANSS and ITRANSL.</summary>
    private const double InverseDigits = 1e-3;

    /// <summary>px: the same of their constants.</summary>
    private const double ConstantDigits = 0.05;

    /// <summary>mm: detectors have pixels of this size.</summary>
    private static readonly (double Min, double Max) Pitches = (1e-3, 1.0);

    /// <summary>Whether the image is mirrored as seen along +z.</summary>
    public bool IsMirrored => Vector3D.Cross(Right, Down).Z < 0.0;

    /// <summary>Axes of an image that is not mirrored.</summary>
    public InstrumentAxes Axes => new(Right, Down);

    /// <summary>A vector of the focal plane, by what it is to the right and down in the image.</summary>
    public (double Right, double Down) ToImage(double x, double y) => ((x * Right.X) + (y * Right.Y), (x * Down.X) + (y * Down.Y));

    /// <summary>The focal plane by ITRANSS and ITRANSL; null if no kernel has ITRANSS.</summary>
    /// <param name="isLine">A line camera's second axis follows its flight, so its image is never mirrored.</param>
    /// <param name="pitchItem">E.g. PIXEL_PITCH.</param>
    /// <exception cref="BadInputException">A keyword is wrong, or they contradict each other.</exception>
    public static FocalPlane? OfTransforms(InstrumentKeywords keywords, bool isLine, string pitchItem)
    {
        if (keywords.Transform("ITRANSS") is not { } samples)
        {
            return null;
        }

        (double Constant, double First, double Second) lines = keywords.Transform("ITRANSL")
            ?? throw keywords.Wrong("ITRANSS", "has no ITRANSL beside it");

        Vector3D acrossSamples = new(samples.First, samples.Second, 0.0);
        Vector3D acrossLines = new(lines.First, lines.Second, 0.0);
        Vector3D down = acrossLines.Normalized();
        Vector3D right = Vector3D.Cross(down, Vector3D.UnitZ);
        if (isLine)
        {
            right = acrossSamples.Normalized();
            down = Vector3D.Cross(Vector3D.UnitZ, right);
        }
        else if (Vector3D.Dot(acrossSamples, right) is var along && along <= 0.0)
        {
            right = along < 0.0 ? -right : throw keywords.Wrong("ITRANSS", "is along ITRANSL");
        }

        CheckInverse(keywords, samples, lines);
        double linesDown = isLine ? acrossLines.Length : Vector3D.Dot(acrossLines, down);
        return new FocalPlane(
            right, down, Checked(Vector3D.Dot(acrossSamples, right), "ITRANSS"), Vector3D.Dot(acrossSamples, down),
            Checked(linesDown, "ITRANSL"), (samples.Constant, lines.Constant));

        double Checked(double perMillimetre, string item) => keywords.Find(pitchItem) is null ? perMillimetre
            : Pitch(keywords, pitchItem) is var pitch && Math.Abs((pitch * perMillimetre) - 1.0) <= PitchDigits ? perMillimetre
            : throw keywords.Wrong(pitchItem, Invariant($"is {pitch} mm, but {item} has {perMillimetre:G9} px a mm"));
    }

    /// <summary>The focal plane of a kernel that has only the pitch.</summary>
    /// <param name="axes">How the image lies in it.</param>
    /// <inheritdoc cref="OfTransforms" path="/exception"/>
    public static FocalPlane OfPitch(InstrumentKeywords keywords, InstrumentAxes axes, string pitchItem)
    {
        double perMillimetre = 1.0 / Pitch(keywords, pitchItem);
        return new FocalPlane(axes.Right, axes.Down, perMillimetre, 0.0, perMillimetre, (0.0, 0.0));
    }

    private static double Pitch(InstrumentKeywords keywords, string item) => keywords.Value(item) switch
    {
        <= 0.0 => throw keywords.Wrong(item, "is not above 0"),
        double pitch when pitch < Pitches.Min || pitch > Pitches.Max => throw keywords.Wrong(
            item, Invariant($"is {pitch}; in mm it lies between {Pitches.Min} and {Pitches.Max}, so it has another unit")),
        double pitch => pitch,
    };

    /// <summary>TRANSX and TRANSY say the same the other way round; a line camera's may lack the second axis.</summary>
    private static void CheckInverse(
        InstrumentKeywords keywords, (double Constant, double First, double Second) samples,
        (double Constant, double First, double Second) lines)
    {
        if (keywords.Find("TRANSX") is not { Numbers: [double x0, double xs, double xl] }
            || keywords.Find("TRANSY") is not { Numbers: [double y0, double ys, double yl] } || (xs * yl) - (xl * ys) == 0.0)
        {
            return;
        }

        double[] slopes =
        [
            (samples.First * xs) + (samples.Second * ys) - 1.0, (samples.First * xl) + (samples.Second * yl),
            (lines.First * xs) + (lines.Second * ys), (lines.First * xl) + (lines.Second * yl) - 1.0,
        ];
        double[] constants =
        [
            samples.Constant + (samples.First * x0) + (samples.Second * y0), lines.Constant + (lines.First * x0) + (lines.Second * y0),
        ];
        if (slopes.Any(slope => Math.Abs(slope) > InverseDigits) || constants.Any(pixels => Math.Abs(pixels) > ConstantDigits))
        {
            throw keywords.Wrong("TRANSX", "and TRANSY are not the inverse of ITRANSS and ITRANSL");
        }
    }
}
