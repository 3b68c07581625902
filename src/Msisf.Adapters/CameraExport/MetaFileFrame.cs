using Msisf.Adapters.Input;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Time;
using System.Xml;
using System.Xml.Linq;

namespace Msisf.Adapters.CameraExport;

/// <summary>Reads the camera of a meta file.</summary>
public static class MetaFileFrame
{
    /// <summary>Reads it; the pixels are not read.</summary>
    /// <param name="scale">Makes a moment of its time.</param>
    /// <exception cref="BadInputException">It is none, is too old to have the camera, or lacks the states of a scan's rows.</exception>
    public static ExportedFrame Read(string path, TimeScale scale) => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        using FileStream stream = File.OpenRead(path);
        return Read(stream, path, scale, () => RowStateFiles.Find(path));
    });

    /// <summary>The same of a stream.</summary>
    /// <param name="stream">The content.</param>
    /// <param name="path">Its name.</param>
    /// <param name="scale">Makes a moment of its time.</param>
    /// <param name="rowStates">The states of all rows of a scan (<see cref="RowStates"/>); null if they are not known.</param>
    /// <inheritdoc cref="Read(string, TimeScale)" path="/exception"/>
    public static ExportedFrame Read(Stream stream, string path, TimeScale scale, Func<double[]?> rowStates)
    {
        try
        {
            XElement general = General(stream) ?? throw new BadInputException(
                $"{path}: there is no GeneralInformation in it. Name a meta file (.xml) of msis.");
            return Frame(general, path, scale, rowStates);
        }
        catch (Exception exception) when (exception is XmlException or FormatException or OverflowException)
        {
            throw new BadInputException($"{path}: is not a meta file of msis: {exception.Message} Name one (.xml).", exception);
        }
    }

    private static XElement? General(Stream stream)
    {
        using XmlReader reader = XmlReader.Create(
            stream, new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
        return reader.ReadToFollowing("GeneralInformation") ? (XElement)XNode.ReadFrom(reader) : null;
    }

    private static ExportedFrame Frame(XElement general, string path, TimeScale scale, Func<double[]?> rowStates)
    {
        XElement camera = general.Element("Camera") ?? throw new BadInputException(
            $"{path}: the file is of a version of msis that did not write the camera yet. Make the image again.");
        XElement? body = general.Element("Body");
        DrawnGlobe globe = body is null ? DrawnGlobe.Moon : new DrawnGlobe(
            CelestialBody.Find(Text(body, "name")) ?? throw new FormatException($"the body '{Text(body, "name")}' is not known."),
            Number(Text(body, "referenceRadius")));
        double[] k = Numbers(Child(camera, "K"), 9);
        int width = int.Parse(Text(camera, "width"), NumberStyles.None, CultureInfo.InvariantCulture);
        int height = int.Parse(Text(camera, "height"), NumberStyles.None, CultureInfo.InvariantCulture);
        ExportedScan? scan = general.Element("Scan") is { } element
            ? ScanRows.Read(element, height, path, rowStates, Number(Child(general, "HeightOverTerrain").Value))
            : null;
        int rows = scan is { Kind: not ScanKind.RollingShutter } ? height / scan.Count : height; // of an exposure
        int rowsAbove = scan is { FlipsFramelets: true } ? rows - 1 : 0; // K is that of the image's top row
        CameraModel model = new(
            width, rows, (k[0], k[4]), (k[2] + 1.0, k[5] + 1.0 + rowsAbove), k[1], Lens(camera.Element("Distortion")));
        XElement q = Child(Child(general, "CameraOrientation"), "Quaternion");
        UnitQuaternion moonFromCamera = UnitQuaternion.FromComponents(
            Number(Text(q, "x")), Number(Text(q, "y")), Number(Text(q, "z")), Number(Text(q, "r")));
        CameraState state = scan?.States[0] ?? new CameraState(Vector(general, "CameraPosition"), moonFromCamera);
        return new ExportedFrame(
            Path.GetFileNameWithoutExtension(path),
            model.At(state),
            scale.InstantOf(TimeText.Parse(Child(Child(general, "SimulationTime"), "UTC").Value)),
            state.SunPositionBodyFixed ?? Vector(general, "SunPosition"),
            globe)
        {
            IsMoving = general.Element("CommandLine")?.Value.Contains(" --motion ", StringComparison.Ordinal) == true,
            Scan = scan,
        };
    }

    private static Distortion? Lens(XElement? element)
    {
        if (element is null)
        {
            return null;
        }

        string model = Text(element, "model");
        double[] c = Numbers(element, model switch
        {
            "opencv" or "brown" => 12,
            "fisheye" => 4,
            "owen" => 6,
            "radial-factor" or "radial-division" => 3,
            "polynomial-radius" or "polynomial-x" => 8,
            _ => throw new FormatException($"the lens '{model}' is not known."),
        });
        return model switch // coefficients are in units of the focal length, which is 1 then
        {
            "opencv" => new OpenCvDistortion([c[0], c[1], .. c.AsSpan(4, 4)], c.AsSpan(2, 2), c.AsSpan(8)),
            "brown" => new BrownDistortion(c.AsSpan(0, 4), c.AsSpan(4, 2), c.AsSpan(6, 4), (c[10], c[11]), 1.0),
            "fisheye" => new FisheyeDistortion(c),
            "owen" => new OwenDistortion(c, 1.0),
            "radial-factor" or "radial-division" => new RadialDistortion(c, model == "radial-division", 1.0),
            _ => new PolynomialDistortion(c.AsSpan(0, 4), c.AsSpan(4), model == "polynomial-radius", 1.0),
        };
    }

    private static Vector3D Vector(XElement general, string name)
    {
        XElement vector = Child(Child(general, name), "Vector3D");
        return new Vector3D(Number(Text(vector, "x")), Number(Text(vector, "y")), Number(Text(vector, "z")));
    }

    private static double[] Numbers(XElement element, int count)
    {
        double[] numbers =
            [.. element.Value.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Select(Number)];
        return numbers.Length == count ? numbers : throw new FormatException(
            Invariant($"{element.Name} has {numbers.Length} numbers, not {count}."));
    }

    internal static double Number(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : throw new FormatException($"'{text}' is not a number.");

    internal static string Text(XElement element, string attribute) => element.Attribute(attribute)?.Value
        ?? throw new FormatException($"{element.Name} has no '{attribute}'.");

    private static XElement Child(XElement element, string name) => element.Element(name)
        ?? throw new FormatException($"{element.Name} has no {name}.");
}
