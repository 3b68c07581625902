using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>The elements that say what a frame was made with: elevation model, camera and input files.</summary>
internal static class OriginXml
{
    /// <summary>Name of the element of an input file.</summary>
    public const string InputElement = "Input";

    /// <summary>Attribute of an input file: SHA-256 of its content.</summary>
    public const string Checksum = "sha256";

    /// <summary>The same of its length and of pieces spread over it.</summary>
    public const string PiecesChecksum = "sha256OfPieces";

    /// <summary>The lines, without the last LF.</summary>
    /// <param name="digits">Of the numbers.</param>
    public static string Lines(FrameMetadata frame, LongEDigits digits) =>
        string.Join(
            '\n',
            [
                .. Body(frame.Globe, digits), Model(frame.Elevation), .. frame.Elevation.Parts.Select(Part),
                .. Camera(CameraMatrix.Of(frame.Camera), digits), .. Orientation(frame), .. frame.Inputs.Select(Input),
            ]);

    /// <summary>A comment that says which kernels give the body's frame, where the user names kernels.</summary>
    private static IEnumerable<string> Orientation(FrameMetadata frame) => frame.Orientation is { } orientation
        ? [$"    <!-- {frame.Globe.Body.Frame}: {orientation.Replace("--", "- -", StringComparison.Ordinal)} -->"]
        : [];

    /// <summary>The word by which an Input element names its kind.</summary>
    public static string WordOf(InputKind kind) => kind switch
    {
        InputKind.ElevationLabel => "elevation-label",
        InputKind.ElevationImage => "elevation-image",
        InputKind.Kernel => "kernel",
        InputKind.AlbedoMap => "albedo-map",
        InputKind.HapkeMap => "hapke-map",
        InputKind.Camera => "camera",
        InputKind.Jitter => "jitter",
        InputKind.Rig => "rig",
        InputKind.CraterCatalogue => "crater-catalogue",
        InputKind.Landmarks => "landmarks",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "Not a kind of input."),
    };

    /// <summary>Names another body than the Moon, its frame and its sphere; files of the Moon need no such line.</summary>
    private static IEnumerable<string> Body(DrawnGlobe globe, LongEDigits digits) => globe.Body.IsMoon
        ? []
        : (string[])
        [
            $"    <Body name=\"{globe.Body.Name}\" frame=\"{globe.Body.Frame}\" "
                + $"referenceRadius=\"{LongE.ToText(globe.ReferenceRadius, digits)}\" unit=\"m\" />",
        ];

    private static string Model(DrawnElevation model) => Invariant(
        $"    <ElevationModel product=\"{XmlText.EscapeAttribute(model.ProductId)}\" synthetic=\"{(model.IsSynthetic ? "yes" : "no")}\""
            + $" drawnFinest=\"{model.FinestDrawn.NumberText}\" drawnCoarsest=\"{model.CoarsestDrawn.NumberText}\" "
            + $"unit=\"{model.FinestDrawn.Unit}\" />");

    private static string Part(ElevationPart part, int number) => Invariant(
        $"    <ElevationPart part=\"{number}\" product=\"{XmlText.EscapeAttribute(part.ProductId)}\" "
            + $"synthetic=\"{(part.IsSynthetic ? "yes" : "no")}\" resolution=\"{part.Resolution.NumberText}\" "
            + $"drawn=\"{part.Drawn?.NumberText ?? "no"}\" "
            + $"unit=\"{part.Resolution.Unit}\"{Moved(part.Moved)}{Misfit(part.Misfit)} />");

    private static string Moved(PartMove? moved) => moved is not { } by ? string.Empty : Invariant(
        $" offset=\"{by.Offset:R}\" shiftEast=\"{by.East:R}\" shiftNorth=\"{by.North:R}\" movedUnit=\"m\"");

    /// <summary>The misfit at the border, rounded to what it can tell.</summary>
    private static string Misfit(PartMisfit? misfit) => misfit is null ? string.Empty : Invariant(
        $" misfitMean=\"{misfit.HeightMean:F2}\" misfitRms=\"{misfit.HeightRms:F2}\" misfitGreatest=\"{misfit.HeightGreatest:F2}\" "
            + $"misfitUnit=\"m\" slopeMisfitMean=\"{misfit.SlopeMean:F3}\" slopeMisfitRms=\"{misfit.SlopeRms:F3}\" "
            + $"slopeMisfitGreatest=\"{misfit.SlopeGreatest:F3}\" slopeMisfitUnit=\"deg\"");

    private static IEnumerable<string> Camera(CameraMatrix camera, LongEDigits digits) =>
    [
        Invariant($"    <Camera width=\"{camera.Width}\" height=\"{camera.Height}\">"),
        "      <K unit=\"px\">",
        .. camera.IntrinsicRows.Select(row => Row(row, digits)),
        "      </K>",
        "      <R>",
        .. camera.RotationRows.Select(row => Row(row, digits)),
        "      </R>",
        "      <t unit=\"m\">",
        Row(camera.Translation, digits),
        "      </t>",
        .. camera.Distortion is { } distortion
            ? [Lens(distortion, digits)]
            : (string[])[],
        "    </Camera>",
    ];

    private static string Lens(Distortion distortion, LongEDigits digits) =>
        $"      <Distortion model=\"{distortion.Name}\">"
            + $"{string.Join(' ', distortion.Coefficients.Select(coefficient => LongE.ToText(coefficient, digits)))}</Distortion>";

    private static string Row(Vector3D row, LongEDigits digits) =>
        $"        {LongE.ToText(row.X, digits)} {LongE.ToText(row.Y, digits)} {LongE.ToText(row.Z, digits)}";

    private static string Input(InputFile file) => Invariant(
        $"    <{InputElement} kind=\"{WordOf(file.Kind)}\" name=\"{XmlText.EscapeAttribute(file.Name)}\" bytes=\"{file.Bytes}\""
            + $" {(file.IsOfPieces ? PiecesChecksum : Checksum)}=\"{file.Sha256}\" />");
}
