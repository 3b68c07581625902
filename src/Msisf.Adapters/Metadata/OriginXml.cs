using System.Text;
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
    /// <param name="digits">Digits of the numbers.</param>
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
        InputKind.StarCatalogue => "star-catalogue",
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

/// <summary>The element of a meta file that says how the camera sits on its body, and where the other cameras of the rig are.</summary>
internal static class RigXml
{
    /// <summary>The lines, each after an LF; empty without a rig.</summary>
    /// <param name="rig">Which camera of a rig took the image; null for none.</param>
    /// <param name="digits">Digits of the numbers.</param>
    public static string Lines(RigCamera? rig, LongEDigits digits)
    {
        if (rig is null)
        {
            return string.Empty;
        }

        StringBuilder text = new();
        text.Append("\n    <Rig camera=\"").Append(rig.Name).Append("\">\n      <Mounting unit=\"m\">");
        AppendPose(text, rig.Mounting, digits);
        text.Append("\n      </Mounting>");
        foreach (MountedCamera other in rig.Cameras.Where((_, index) => index != rig.Index))
        {
            text.Append("\n      <OtherCamera name=\"").Append(other.Name).Append("\" unit=\"m\">");
            AppendPose(text, other.Mounting.SeenFrom(rig.Mounting), digits);
            text.Append("\n      </OtherCamera>");
        }

        return text.Append("\n    </Rig>").ToString();
    }

    private static void AppendPose(StringBuilder text, Mounting pose, LongEDigits digits) => text
        .Append("\n        ").Append(VectorXml.Of(pose.OffsetBody, digits))
        .Append("\n        ").Append(VectorXml.Of(pose.BodyFromCamera, digits));
}

/// <summary>The element of a meta file that says when, and in which state, the rows of a scanned image were exposed.</summary>
internal static class ScanXml
{
    /// <summary>The lines, each after an LF; empty for a frame.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="grid">The rows that are named.</param>
    /// <param name="digits">Digits of the numbers.</param>
    public static string Lines(FrameMetadata frame, PixelGrid grid, LongEDigits digits)
    {
        if (frame.Scan is not { } scan)
        {
            return string.Empty;
        }

        StringBuilder text = new();
        text.Append(
            CultureInfo.InvariantCulture,
            $"\n    <Scan kind=\"{WordOf(scan.Kind)}\" exposures=\"{scan.Count}\" period=\"{scan.Period:R}\" stages=\"{scan.Stages}\"")
            .Append(scan.Kind == ScanKind.PushFrame ? $" flip=\"{(scan.FlipsFramelets ? "yes" : "no")}\">" : ">");
        for (int row = 0; row < grid.Rows; row++)
        {
            int y = grid.PixelY(row);
            double[] numbers = RowStates.Of(frame, y);
            text.Append(CultureInfo.InvariantCulture, $"\n      <Row v=\"{y}\" mjd=\"")
                .Append(LongE.ToText(frame.SimulationTime.After(numbers[0]).Mjd, digits)).Append('"');
            for (int i = 0; i < numbers.Length; i++)
            {
                text.Append(' ').Append(RowStates.Names[i]).Append("=\"").Append(LongE.ToText(numbers[i], digits)).Append('"');
            }

            text.Append(" />");
        }

        return text.Append("\n    </Scan>").ToString();
    }

    /// <summary>The kind of a word; null for another word.</summary>
    internal static ScanKind? KindOf(string word) =>
        Enum.GetValues<ScanKind>().Cast<ScanKind?>().FirstOrDefault(kind => WordOf(kind!.Value) == word);

    private static string WordOf(ScanKind kind) => kind switch
    {
        ScanKind.LineScan => "line-scan",
        ScanKind.PushFrame => "push-frame",
        ScanKind.RollingShutter => "rolling-shutter",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "Not a kind of scan."),
    };
}
