using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Navigation;

/// <summary>
/// Writes the craters of a frame as COCO's object detection format has it: boxes and polygons from the upper left corner of the image,
/// cut off at its borders, and, beyond COCO, the ellipse and the crater.
/// </summary>
public static class CocoWriter
{
    private const int PolygonPoints = 32;

    /// <summary>Writes the craters.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="camera">The frame's.</param>
    /// <param name="image">Number and file name of the image.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(
        Stream stream, CratersOfFrame craters, ICamera camera, (int Number, string FileName) image, double referenceRadius)
    {
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            WriteHead(json, (camera.Width, camera.Height), [image]);
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

    /// <summary>Writes the images, and the only category that there is.</summary>
    /// <param name="json">Receives them, inside an object.</param>
    /// <param name="size">Width and height of the images, px.</param>
    /// <param name="images">Number and file name of each.</param>
    public static void WriteHead(Utf8JsonWriter json, (int Width, int Height) size, IEnumerable<(int Number, string FileName)> images)
    {
        json.WriteStartArray("images");
        foreach ((int number, string fileName) in images)
        {
            json.WriteStartObject();
            json.WriteNumber("id", number);
            json.WriteNumber("width", size.Width);
            json.WriteNumber("height", size.Height);
            json.WriteString("file_name", fileName);
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

    private static void WriteAnnotation(Utf8JsonWriter json, CraterView view, ICamera camera, int image, double referenceRadius)
    {
        // COCO counts from the corner of the first pixel, rendering coordinates have its centre at 1.
        ImageEllipse ellipse = view.Ellipse;
        (double right, double down) = ellipse.Reach;
        double left = Math.Clamp(ellipse.X - right - 0.5, 0.0, camera.Width);
        double top = Math.Clamp(ellipse.Y - down - 0.5, 0.0, camera.Height);
        json.WriteStartObject();
        json.WriteNumber("id", view.Crater.Number);
        json.WriteNumber("image_id", image);
        json.WriteNumber("category_id", 1);
        json.WriteNumber("iscrowd", 0);
        json.WriteNumbers(
            "bbox", left, top, Math.Clamp(ellipse.X + right - 0.5, 0.0, camera.Width) - left,
            Math.Clamp(ellipse.Y + down - 0.5, 0.0, camera.Height) - top);
        json.WriteNumber("area", ellipse.Area * view.Inside);
        json.WriteStartArray("segmentation");
        json.WriteNumbers(PolygonOf(ellipse, camera.Width, camera.Height));
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

        if (view.Covariance is { } covariance)
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

    /// <summary>The part of an ellipse in the image as a polygon: x, y, x, y, ... from the image's corner.</summary>
    private static IEnumerable<double> PolygonOf(ImageEllipse ellipse, int width, int height)
    {
        List<(double X, double Y)> polygon =
        [
            .. Enumerable.Range(0, PolygonPoints).Select(i => ellipse.PointAt(2.0 * Math.PI * i / PolygonPoints))
                .Select(point => (point.X - 0.5, point.Y - 0.5)),
        ];
        polygon = Cut(polygon, point => point.X, width);
        polygon = Cut(polygon, point => point.Y, height);
        return polygon.SelectMany(point => (double[])[point.X, point.Y]);
    }

    /// <summary>Cuts a convex polygon off below 0 and above a limit (Sutherland and Hodgman, Commun. ACM 17 (1974) 32).</summary>
    private static List<(double X, double Y)> Cut(List<(double X, double Y)> polygon, Func<(double X, double Y), double> of, double limit)
    {
        polygon = CutAt(polygon, point => of(point), 0.0);
        return CutAt(polygon, point => -of(point), -limit);
    }

    private static List<(double X, double Y)> CutAt(
        List<(double X, double Y)> polygon, Func<(double X, double Y), double> of, double least)
    {
        List<(double X, double Y)> kept = [];
        for (int i = 0; i < polygon.Count; i++)
        {
            (double X, double Y) from = polygon[i];
            (double X, double Y) to = polygon[(i + 1) % polygon.Count];
            (double first, double last) = (of(from) - least, of(to) - least);
            if (first >= 0.0)
            {
                kept.Add(from);
            }

            if ((first >= 0.0) != (last >= 0.0))
            {
                double part = first / (first - last);
                kept.Add((from.X + (part * (to.X - from.X)), from.Y + (part * (to.Y - from.Y))));
            }
        }

        return kept;
    }
}
