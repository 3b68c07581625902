using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.CameraImport;
using Msisf.Adapters.Input;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Adapters.Camera;

/// <summary>
/// Reads camera files (docs/cameras.md): the keys of the top level; each section has a class of its own. Files of other programs become
/// such keys first (<see cref="CameraFormats"/>).
/// </summary>
public static class CameraFileReader
{
    /// <summary>px: maximum width and height.</summary>
    public const int MaxSide = 16384;

    /// <summary>Bytes: the states of a long scan have some million; of a cube no more than this is read.</summary>
    private const int LargestFile = 64 << 20;

    private const double MetresPerMillimetre = 1e-3;

    /// <summary>mm: shorter than any camera's; a focal length in metres looks so.</summary>
    private const double ShortestFocalLength = 0.1;

    private static readonly string[] Keys =
    [
        "description", "width", "height", "focal-length", "pixel-pitch", "focal-length-px", "field-of-view", "principal-point",
        "pixel-convention", "skew", "distortion", "detector", "scan",
    ];

    /// <summary>Coordinates of the middle of the first pixel, by convention.</summary>
    private static readonly (string Name, double First)[] Conventions =
        [("msis", 1.0), ("opencv", 0.0), ("colmap", 0.5), ("isis", 1.0), ("matlab", 1.0)];

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file; of one with several cameras <c>FILE,camera=NAME</c>.</param>
    /// <param name="preset">Name of the preset; null for a file of the user, which is named by its file name.</param>
    /// <param name="size">Width and height, px, for a file that does not say them; null where they are not known.</param>
    /// <exception cref="BadInputException">There is no such file, or what is wrong in it, by file, line and column.</exception>
    public static CameraFile Read(string path, string? preset = null, (int? Width, int? Height) size = default)
    {
        byte[] content = FileErrors.ToBadInput($"{path}: the camera file can't be read", () =>
        {
            using FileStream stream = File.OpenRead(CameraFormats.Split(path).Path);
            byte[] bytes = new byte[stream.CanSeek ? Math.Min(stream.Length, LargestFile) : LargestFile];
            return bytes[..stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false)];
        });
        return Parse(content, path, preset, size: size);
    }

    /// <summary>Reads a file's content.</summary>
    /// <param name="path">For messages; of a file with several cameras <c>FILE,camera=NAME</c>.</param>
    /// <param name="preset">Name of the preset; null for a file of the user.</param>
    /// <param name="mayNameFiles">Whether it may name another file, the PSF's kernel.</param>
    /// <param name="size">Width and height, px, for a file that does not say them; null where they are not known.</param>
    /// <exception cref="BadInputException">What is wrong in it, by file, line and column.</exception>
    public static CameraFile Parse(
        byte[] content, string path, string? preset = null, bool mayNameFiles = true, (int? Width, int? Height) size = default)
    {
        (string filePath, string? camera) = CameraFormats.Split(path);
        using MemoryStream stream = new(content);
        SettingsSection file = new(
            filePath, "a camera", (1, 1),
            CameraFormats.Read(content, filePath, camera) ?? ConfigFileReader.Read(stream, filePath, levels: 1), Keys);
        int? ownWidth = file.Whole("width", 1, MaxSide);
        int? ownHeight = file.Whole("height", 1, MaxSide);
        int width = ownWidth ?? size.Width ?? throw file.Missing("width", "how many pixels a row of the image has; or give --width");
        int height = ownHeight ?? size.Height ?? throw file.Missing("height", "how many rows the image has; or give --height");
        (double FocalLength, (double X, double Y) Pitch)? metric = Metric(file);
        (double X, double Y) focal = FocalPixels(file, width, metric);
        (double x, double y) = PrincipalPoint(file, width, height);
        double skew = file.Number("skew") ?? 0.0;
        Distortion? distortion = DistortionSection.Read(file, metric is null ? null : focalMillimetres(metric.Value.FocalLength));
        CameraModel model;
        try
        {
            model = new CameraModel(width, height, focal, (x, y), skew, distortion).Simplified();
            if (model.Distortion is null && file.Number("field-of-view") is double degrees && model.FocalX == model.FocalY
                && !file.Has("principal-point") && skew == 0.0)
            {
                model = CameraModel.FromFieldOfView(degrees * Math.PI / 180.0, width, height);
            }
        }
        catch (BadInputException exception)
        {
            throw file.Wrong(distortion is null ? FocalKey(file) : "distortion", exception.Message.TrimEnd('.'));
        }

        CameraFileDetector? detector = DetectorSection.Read(
            file, new DetectorGeometry(path, width, height, metric?.FocalLength, metric?.Pitch, mayNameFiles));
        CameraFileScan? scan = ScanSection.Read(file, height, detector);
        if (scan is { Kind: not ScanKind.RollingShutter } && detector?.Settings.FarWings is not null)
        {
            throw file.Wrong(
                "scan", "'psf-wings' spreads light over a whole image, and lines and framelets are images of their own. Leave one out");
        }

        return new CameraFile(
            preset ?? Path.GetFileName(path), Checksum(content, detector), file.Text("description"), model,
            metric?.FocalLength, metric?.Pitch, path, content.Length, preset is not null,
            model.Distortion is null && file.Number("field-of-view") is double given ? given : double.RadiansToDegrees(model.FieldOfView),
            detector)
        {
            AddedWidth = ownWidth is null ? width : null,
            AddedHeight = ownHeight is null ? height : null,
            Scan = scan,
        };

        static double focalMillimetres(double focalLength) => focalLength / MetresPerMillimetre;
    }

    /// <summary>Checksum of the file and of the kernel that it names.</summary>
    private static string Checksum(byte[] content, CameraFileDetector? detector) => Convert.ToHexStringLower(SHA256.HashData(
        detector?.KernelSha256 is string kernel ? [.. content, .. Encoding.ASCII.GetBytes(kernel)] : content));

    /// <summary>The key that gives the focal length; exactly one of three does.</summary>
    private static string FocalKey(SettingsSection file)
    {
        string[] ways = ["focal-length", "focal-length-px", "field-of-view"];
        string[] given = [.. ways.Where(file.Has)];
        return given.Length switch
        {
            0 => throw file.Missing("focal-length", "the focal length in mm; 'focal-length-px' and 'field-of-view' (degrees) do as well"),
            1 => given[0],
            _ => throw file.Wrong(given[1], $"'{given[0]}' and '{given[1]}' exclude each other. Leave one out"),
        };
    }

    private static (double FocalLength, (double X, double Y) Pitch)? Metric(SettingsSection file)
    {
        double? focalLength = FocalKey(file) == "focal-length" ? file.Positive("focal-length") : null;
        if (focalLength < ShortestFocalLength)
        {
            throw file.Wrong("focal-length", Invariant(
                $"'focal-length' is {focalLength} mm; it is in millimetres (mm), from {ShortestFocalLength} on. ")
                    + "Metres are to be multiplied by 1000");
        }

        double[]? pitch = file.Numbers("pixel-pitch", 1, 2);
        if (pitch is not null && pitch.Min() <= 0.0)
        {
            throw file.Wrong("pixel-pitch", "'pixel-pitch' is not above 0; the distance of two pixels in mm is needed");
        }

        if (focalLength is null != pitch is null)
        {
            throw focalLength is null
                ? file.Wrong("pixel-pitch", "'pixel-pitch' has no meaning without 'focal-length' in mm. Leave it out")
                : file.Missing("pixel-pitch", "the distance of two pixels in mm, or two of them, along rows and columns");
        }

        return focalLength is null
            ? null
            : (focalLength.Value * MetresPerMillimetre, (pitch![0] * MetresPerMillimetre, pitch[^1] * MetresPerMillimetre));
    }

    private static (double X, double Y) FocalPixels(
        SettingsSection file, int width, (double FocalLength, (double X, double Y) Pitch)? metric)
    {
        if (metric is { } known)
        {
            return (known.FocalLength / known.Pitch.X, known.FocalLength / known.Pitch.Y);
        }

        if (file.Numbers("focal-length-px", 1, 2) is { } pixels)
        {
            return pixels.Min() > 0.0
                ? (pixels[0], pixels[^1])
                : throw file.Wrong("focal-length-px", "'focal-length-px' is not above 0; the focal length in px is needed");
        }

        double degrees = file.Number("field-of-view")!.Value;
        if (!(degrees > 0.0 && degrees < CameraModel.MaxFieldDegrees))
        {
            throw file.Wrong(
                "field-of-view",
                $"'field-of-view' is {file.Text("field-of-view")}; degrees above 0 and below {CameraModel.MaxFieldDegrees} are needed");
        }

        double focal = 0.5 * width / Math.Tan(degrees * Math.PI / 360.0);
        return (focal, focal);
    }

    /// <summary>In rendering coordinates; the middle of the image if the file does not say it.</summary>
    private static (double X, double Y) PrincipalPoint(SettingsSection file, int width, int height)
    {
        string convention = file.Word("pixel-convention", [.. Conventions.Select(one => one.Name)]) ?? Conventions[0].Name;
        double first = Conventions.First(one => one.Name == convention).First;
        return file.Numbers("principal-point", 2, 2) is [double x, double y]
            ? (x - first + 1.0, y - first + 1.0)
            : (0.5 * (1.0 + width), 0.5 * (1.0 + height));
    }
}
