using Msisf.Adapters.Input;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Time;
using System.Xml;
using System.Xml.Linq;

namespace Msisf.Adapters.CameraExport;

/// <summary>The camera of a frame as its meta file has it, whether that is read or only known.</summary>
public static class MetaFileFrame
{
    /// <summary>The camera of a frame with the digits of its meta file, so that a model is the same as when it is made from that.</summary>
    /// <param name="name">File name of the image, without extension.</param>
    /// <param name="frame">What the meta file is written from.</param>
    public static ExportedFrame Of(string name, FrameMetadata frame)
    {
        CameraMatrix camera = CameraMatrix.Of(frame.Camera);
        UnitQuaternion q = frame.Camera.MoonFromCamera;
        return new Numbers(
            (camera.Width, camera.Height), [.. camera.IntrinsicRows.SelectMany(Rounded)],
            camera.Distortion is { } lens ? Lens(lens.Name, [.. lens.Coefficients.Select(LongE.Round)]) : null,
            new CameraState(
                RoundedVector(frame.Camera.PositionBodyFixed),
                UnitQuaternion.FromComponents(LongE.Round(q.X), LongE.Round(q.Y), LongE.Round(q.Z), LongE.Round(q.W))),
            RoundedVector(frame.SunPositionBodyFixed),
            frame.Scan is { } scan ? ScanRows.Of(scan, frame) : null).ToExported(
                name, frame.SimulationTime, frame.CommandLine,
                frame.Globe.Body.IsMoon
                    ? DrawnGlobe.Moon
                    : frame.Globe with { ReferenceRadius = LongE.Round(frame.Globe.ReferenceRadius) });
    }

    /// <summary>Reads it; the pixels are not read.</summary>
    /// <param name="scale">Makes a moment of its time.</param>
    /// <exception cref="BadInputException">It is none, is too old to have the camera, or lacks the states of a scan's rows.</exception>
    public static ExportedFrame Read(string path, TimeScale scale) => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            XElement general = General(stream) ?? throw new BadInputException(
                $"{path}: there is no GeneralInformation in it. Name a meta file (.xml) of msis.");
            return Frame(general, path, scale);
        }
        catch (Exception exception) when (exception is XmlException or FormatException or OverflowException)
        {
            throw new BadInputException($"{path}: is not a meta file of msis: {exception.Message} Name one (.xml).", exception);
        }
    });

    private static XElement? General(Stream stream)
    {
        using XmlReader reader = XmlReader.Create(
            stream, new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null });
        return reader.ReadToFollowing("GeneralInformation") ? (XElement)XNode.ReadFrom(reader) : null;
    }

    private static ExportedFrame Frame(XElement general, string path, TimeScale scale)
    {
        XElement camera = general.Element("Camera") ?? throw new BadInputException(
            $"{path}: the file is of a version of msis that did not write the camera yet. Make the image again.");
        XElement? body = general.Element("Body");
        DrawnGlobe globe = body is null ? DrawnGlobe.Moon : new DrawnGlobe(
            CelestialBody.Find(Text(body, "name")) ?? throw new FormatException($"the body '{Text(body, "name")}' is not known."),
            Number(Text(body, "referenceRadius")));
        double[] k = NumbersOf(Child(camera, "K"), 9);
        int height = int.Parse(Text(camera, "height"), NumberStyles.None, CultureInfo.InvariantCulture);
        XElement q = Child(Child(general, "CameraOrientation"), "Quaternion");
        return new Numbers(
            (int.Parse(Text(camera, "width"), NumberStyles.None, CultureInfo.InvariantCulture), height), k,
            camera.Element("Distortion") is { } lens ? Lens(Text(lens, "model"), NumbersOf(lens)) : null,
            new CameraState(
                Vector(general, "CameraPosition"),
                UnitQuaternion.FromComponents(Number(Text(q, "x")), Number(Text(q, "y")), Number(Text(q, "z")), Number(Text(q, "r")))),
            Vector(general, "SunPosition"),
            general.Element("Scan") is { } element
                ? ScanRows.Read(element, height, path, Number(Child(general, "HeightOverTerrain").Value))
                : null).ToExported(
                    Path.GetFileNameWithoutExtension(path),
                    scale.InstantOf(TimeText.Parse(Child(Child(general, "SimulationTime"), "UTC").Value)),
                    general.Element("CommandLine")?.Value ?? string.Empty, globe);
    }

    private static Distortion Lens(string model, double[] c)
    {
        int count = model switch
        {
            "opencv" or "brown" => 12,
            "fisheye" => 4,
            "owen" => 6,
            "radial-factor" or "radial-division" => 3,
            "polynomial-radius" or "polynomial-x" => 8,
            _ => throw new FormatException($"the lens '{model}' is not known."),
        };
        RequireCount("Distortion", c, count);
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

    private static double[] Rounded(Vector3D row) => [LongE.Round(row.X), LongE.Round(row.Y), LongE.Round(row.Z)];

    private static Vector3D RoundedVector(Vector3D v) => new(LongE.Round(v.X), LongE.Round(v.Y), LongE.Round(v.Z));

    private static Vector3D Vector(XElement general, string name)
    {
        XElement vector = Child(Child(general, name), "Vector3D");
        return new Vector3D(Number(Text(vector, "x")), Number(Text(vector, "y")), Number(Text(vector, "z")));
    }

    private static double[] NumbersOf(XElement element) =>
        [.. element.Value.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Select(Number)];

    private static double[] NumbersOf(XElement element, int count)
    {
        double[] numbers = NumbersOf(element);
        RequireCount(element.Name.LocalName, numbers, count);
        return numbers;
    }

    private static void RequireCount(string element, double[] numbers, int count)
    {
        if (numbers.Length != count)
        {
            throw new FormatException(Invariant($"{element} has {numbers.Length} numbers, not {count}."));
        }
    }

    internal static double Number(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : throw new FormatException($"'{text}' is not a number.");

    internal static string Text(XElement element, string attribute) => element.Attribute(attribute)?.Value
        ?? throw new FormatException($"{element.Name} has no '{attribute}'.");

    private static XElement Child(XElement element, string name) => element.Element(name)
        ?? throw new FormatException($"{element.Name} has no {name}.");

    /// <summary>What a meta file says of a camera.</summary>
    /// <param name="Size">px: width and height of the image.</param>
    /// <param name="K">By rows.</param>
    /// <param name="State">State of a frame.</param>
    private sealed record Numbers(
        (int Width, int Height) Size, double[] K, Distortion? Lens, CameraState State, Vector3D Sun, ExportedScan? Scan)
    {
        public ExportedFrame ToExported(string name, Instant time, string commandLine, DrawnGlobe globe)
        {
            int rows = Scan is { Kind: not ScanKind.RollingShutter } ? Size.Height / Scan.Count : Size.Height; // of an exposure
            int rowsAbove = Scan is { FlipsFramelets: true } ? rows - 1 : 0; // K is that of the image's top row
            CameraModel model = new(Size.Width, rows, (K[0], K[4]), (K[2] + 1.0, K[5] + 1.0 + rowsAbove), K[1], Lens);
            CameraState state = Scan?.States[0] ?? State;
            return new ExportedFrame(name, model.At(state), time, state.SunPositionBodyFixed ?? Sun, globe)
            {
                IsMoving = commandLine.Contains(" --motion ", StringComparison.Ordinal),
                Scan = Scan,
            };
        }
    }
}
