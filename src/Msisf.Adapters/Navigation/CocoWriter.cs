using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Time;

namespace Msisf.Adapters.Navigation;

/// <summary>
/// Writes craters in COCO's object detection format: boxes and polygons from the upper left corner of the image, cut off at its borders,
/// and, beyond COCO, the ellipse and the crater. Craters whose part in the image is smaller than a pixel are left out.
/// </summary>
public static class CocoWriter
{
    /// <summary>px^2.</summary>
    private const double LeastArea = 1.0;

    /// <summary>Decimals of polygons and boxes: a thousandth of a pixel.</summary>
    private const int Decimals = 3;

    /// <summary>The hidden part of a crater from which on it is to be ignored; as in annotated images.</summary>
    private const double MostHidden = 0.5;

    /// <summary>The lit part of what an image shows of a crater below which it is to be ignored.</summary>
    private const double LeastLit = 0.1;

    /// <summary>Writes the craters of an image.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="camera">The frame's.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(
        Stream stream, CratersOfFrame craters, ICamera camera, CocoSource source, CocoImage image, double referenceRadius)
    {
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            WriteHead(json, source, (camera.Width, camera.Height), [image]);
            json.WriteStartArray("annotations");
            foreach (CraterView view in craters.Views)
            {
                WriteAnnotation(json, view, camera, image.Number, referenceRadius);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
    }

    /// <summary>Writes all but the annotations: about the file, its licences and images, and the only category that there is.</summary>
    /// <param name="json">Receives them, inside an object.</param>
    /// <param name="size">Width and height of the images, px.</param>
    public static void WriteHead(Utf8JsonWriter json, CocoSource source, (int Width, int Height) size, IReadOnlyList<CocoImage> images)
    {
        string date = images.Count > 0 ? DayOf(images[0]) : string.Empty;
        json.WriteStartObject("info");
        json.WriteNumber("year", date.Length > 0 ? int.Parse(date.AsSpan(0, date.IndexOf('-', 1)), CultureInfo.InvariantCulture) : 0);
        json.WriteString("version", source.Version);
        json.WriteString("description", source.Description);
        json.WriteString("contributor", $"msis {source.Version}");
        json.WriteString("url", string.Empty);
        json.WriteString("date_created", date.Replace('-', '/'));
        json.WriteEndObject();
        json.WriteStartArray("licenses");
        foreach ((int index, string licence) in source.Licences.Index())
        {
            json.WriteStartObject();
            json.WriteNumber("id", index + 1);
            json.WriteString("name", licence);
            json.WriteString("url", string.Empty);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("images");
        foreach (CocoImage image in images)
        {
            json.WriteStartObject();
            json.WriteNumber("id", image.Number);
            json.WriteNumber("width", size.Width);
            json.WriteNumber("height", size.Height);
            json.WriteString("file_name", image.FileName);
            json.WriteNumber("license", 1);
            json.WriteString("date_captured", image.Time.Utc.RoundedTo(Duration.OfSeconds(1)).ToString().Replace('T', ' '));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("categories");
        json.WriteStartObject();
        json.WriteNumber("id", 1);
        json.WriteString("name", "crater");
        json.WriteString("supercategory", "landform");
        json.WriteEndObject();
        json.WriteEndArray();
    }

    private static string DayOf(CocoImage image)
    {
        string time = image.Time.ToIsoUtc();
        return time[..time.IndexOf('T', StringComparison.Ordinal)];
    }

    private static void WriteAnnotation(Utf8JsonWriter json, CraterView view, ICamera camera, int image, double referenceRadius)
    {
        // COCO counts from the corner of the first pixel, rendering coordinates have its centre at 1.
        RenderingPoint[] polygon =
        [
            .. EllipsePolygon.Of(view.Ellipse, camera.Width, camera.Height)
                .Select(corner => new RenderingPoint(Rounded(corner.X - 0.5), Rounded(corner.Y - 0.5)))
                .Distinct(),
        ];
        double area = EllipsePolygon.AreaOf(polygon);
        if (!(area >= LeastArea))
        {
            return;
        }

        double left = polygon.Min(corner => corner.X);
        double top = polygon.Min(corner => corner.Y);
        json.WriteStartObject();
        json.WriteNumber("id", view.Crater.Number);
        json.WriteNumber("image_id", image);
        json.WriteNumber("category_id", 1);
        json.WriteNumber("iscrowd", 0);
        json.WriteNumber("ignore", IsToBeIgnored(view) ? 1 : 0);
        json.WriteNumbers(
            "bbox", left, top, Rounded(polygon.Max(corner => corner.X) - left), Rounded(polygon.Max(corner => corner.Y) - top));
        json.WriteNumber("area", area);
        json.WriteStartArray("segmentation");
        json.WriteNumbers(polygon.SelectMany(corner => (double[])[corner.X, corner.Y]));
        json.WriteEndArray();
        json.WriteStartObject("crater");
        json.WriteString("id", view.Crater.Identity);
        json.WriteString("name", view.Crater.Name);
        foreach ((string name, double? value) in CraterFields.Of(view, referenceRadius))
        {
            if (value is { } number)
            {
                json.WriteNumber(name, number);
            }
            else
            {
                json.WriteNull(name);
            }
        }

        if (CraterFields.CovarianceOf(view) is { } covariance)
        {
            json.WriteNumbers("covariance", covariance);
        }

        if (view.Curve.Count > 0)
        {
            json.WriteNumbers("curve", view.Curve.SelectMany(point => (double[])[point.X, point.Y]));
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }

    /// <summary>Whether an image shows so little of a crater, or so little of it lit, that nobody can find it there.</summary>
    private static bool IsToBeIgnored(CraterView view) => !(view.Hidden <= MostHidden && view.Lit >= LeastLit);

    private static double Rounded(double number) => Math.Round(number, Decimals);
}

/// <summary>What a file in COCO's format is of.</summary>
/// <param name="Version">Version of msis.</param>
/// <param name="Licences">The first is that of the images; at least one.</param>
public sealed record CocoSource(string Description, string Version, IReadOnlyList<string> Licences)
{
    /// <summary>Name of a licence that nobody has stated.</summary>
    public const string NoLicence = "not stated";
}

/// <summary>An image that a file in COCO's format names.</summary>
/// <param name="Number">Its identity, at least 1.</param>
/// <param name="Time">UTC of the scene.</param>
public sealed record CocoImage(int Number, string FileName, Instant Time);
