using System.Globalization;
using System.Text.Json;

namespace Msisf.TestSupport;

/// <summary>
/// An independent reader of COCO's object detection format (https://cocodataset.org/#format-data): what must be there and agree, and the
/// part of each crater's ellipse inside the image, followed point by point.
/// </summary>
public sealed class CocoRules
{
    /// <summary>px: how far a polygon may lie from the ellipse.</summary>
    private const double HalfPixel = 0.5;

    /// <summary>px: boxes and polygons are written in thousandths.</summary>
    private const double Written = 0.0011;

    private const int EllipsePoints = 8_000;

    private readonly Dictionary<int, (int Width, int Height)> _images = [];
    private readonly HashSet<int> _annotations = [];

    /// <summary>Boxes that the ellipses themselves have, cut off at the image, are another one: how often.</summary>
    public int CutInside { get; private set; }

    /// <summary>Number of annotations.</summary>
    public int Annotations => _annotations.Count;

    /// <summary>Number of annotations that loaders are to leave out.</summary>
    public int Ignored { get; private set; }

    /// <summary>Number of images.</summary>
    public int Images => _images.Count;

    /// <summary>Reads a file; the first rule that is broken is an error.</summary>
    public static CocoRules Check(string path)
    {
        CocoRules rules = new();
        using JsonDocument json = JsonDocument.Parse(File.ReadAllBytes(path));
        rules.ReadHead(json.RootElement);
        foreach (JsonElement annotation in json.RootElement.GetProperty("annotations").EnumerateArray())
        {
            rules.Read(annotation);
        }

        return rules;
    }

    private static void Require(bool isMet, string rule)
    {
        if (!isMet)
        {
            throw new InvalidDataException(rule);
        }
    }

    private void ReadHead(JsonElement root)
    {
        JsonElement info = root.GetProperty("info");
        Require(info.GetProperty("year").GetInt32() > 1900, "info.year is a year");
        foreach (string name in (string[])["version", "description", "contributor", "url", "date_created"])
        {
            Require(info.GetProperty(name).GetString() is not null, $"info.{name} is a text");
        }

        Require(
            DateOnly.TryParseExact(
                info.GetProperty("date_created").GetString(), "yyyy/MM/dd", CultureInfo.InvariantCulture, default, out _),
            "info.date_created is a date");
        HashSet<int> licences = [];
        foreach (JsonElement licence in root.GetProperty("licenses").EnumerateArray())
        {
            Require(licences.Add(licence.GetProperty("id").GetInt32()), "licences have identities of their own");
            Require(licence.GetProperty("name").GetString()!.Length > 0 && licence.GetProperty("url").GetString() is not null, "licence");
        }

        JsonElement category = root.GetProperty("categories").EnumerateArray().Single();
        Require(category.GetProperty("id").GetInt32() == 1 && category.GetProperty("name").GetString() == "crater", "category");
        Require(category.GetProperty("supercategory").GetString() is not null, "categories have supercategories");
        foreach (JsonElement image in root.GetProperty("images").EnumerateArray())
        {
            (int, int) size = (image.GetProperty("width").GetInt32(), image.GetProperty("height").GetInt32());
            Require(_images.TryAdd(image.GetProperty("id").GetInt32(), size), "images have identities of their own");
            Require(image.GetProperty("file_name").GetString()!.EndsWith(".png", StringComparison.Ordinal), "images have files");
            Require(licences.Contains(image.GetProperty("license").GetInt32()), "the licence of an image is listed");
            Require(
                DateTime.TryParseExact(
                    image.GetProperty("date_captured").GetString(), "yyyy-MM-dd HH:mm:ss", CultureInfo.InvariantCulture, default, out _),
                "date_captured is a time");
        }
    }

    private void Read(JsonElement annotation)
    {
        Require(_annotations.Add(annotation.GetProperty("id").GetInt32()), "annotations have identities of their own");
        (int width, int height) = _images[annotation.GetProperty("image_id").GetInt32()];
        Require(annotation.GetProperty("category_id").GetInt32() == 1, "the category is listed");
        Require(annotation.GetProperty("iscrowd").GetInt32() == 0, "polygons are of single objects");
        JsonElement crater = annotation.GetProperty("crater");
        double? Part(string name) => crater.GetProperty(name) is { ValueKind: JsonValueKind.Number } number ? number.GetDouble() : null;
        bool isFound = Part("hidden") <= 0.5 && Part("lit") >= 0.1;
        Require(annotation.GetProperty("ignore").GetInt32() == (isFound ? 0 : 1), "hidden and unlit craters are marked");
        Ignored += isFound ? 0 : 1;

        double[] numbers = Numbers(annotation.GetProperty("segmentation").EnumerateArray().Single());
        Require(numbers.Length >= 6 && numbers.Length % 2 == 0, "a polygon has three corners at least");
        (double X, double Y)[] polygon = [.. numbers.Chunk(2).Select(pair => (pair[0], pair[1]))];
        Require(polygon.All(corner => corner.X >= 0.0 && corner.X <= width && corner.Y >= 0.0 && corner.Y <= height), "inside the image");
        double[] box = Numbers(annotation.GetProperty("bbox"));
        Require(box[2] > 0.0 && box[3] > 0.0, "a box has a size");
        RequireSame(box, BoxOf(polygon), Written, "the box is that of the polygon");
        double area = annotation.GetProperty("area").GetDouble();
        Require(Math.Abs(area - AreaOf(polygon)) <= 1e-6 * area, $"the area is that of the polygon: {area}, {AreaOf(polygon)}");
        Require(area >= 1.0, "slivers are left out");
        CheckEllipse(crater, polygon, box, area, (width, height));
    }

    /// <summary>The ellipse, from its own numbers: points all around it, those in the image, and the image's corners in it.</summary>
    private void CheckEllipse(
        JsonElement crater, (double X, double Y)[] polygon, double[] box, double area, (int Width, int Height) image)
    {
        double Of(string name) => crater.GetProperty(name).GetDouble();
        (double x, double y, double major, double minor) = (Of("h") - 0.5, Of("v") - 0.5, Of("semiMajor"), Of("semiMinor"));
        (double sin, double cos) = Math.SinCos(double.DegreesToRadians(Of("turn")));
        (double X, double Y)[] all = [.. Enumerable.Range(0, EllipsePoints).Select(i =>
        {
            (double sinOf, double cosOf) = Math.SinCos(2.0 * Math.PI * i / EllipsePoints);
            return (x + (major * cos * cosOf) - (minor * sin * sinOf), y + (major * sin * cosOf) + (minor * cos * sinOf));
        })];
        double spacing = 2.0 * Math.PI * major / EllipsePoints;
        (double X, double Y)[] part =
        [
            .. all.Where(point => point.X >= 0.0 && point.X <= image.Width && point.Y >= 0.0 && point.Y <= image.Height),
            .. ((double X, double Y)[])[(0.0, 0.0), (image.Width, 0.0), (0.0, image.Height), (image.Width, image.Height)],
        ];
        part = [.. part.Where((point, index) => index < part.Length - 4 || IsIn(point))];
        RequireSame(box, BoxOf(part), Written + (2.0 * spacing), "the box is that of the part in the image");
        double[] cut = BoxOf([.. all.Select(point => (Math.Clamp(point.X, 0.0, image.Width), Math.Clamp(point.Y, 0.0, image.Height)))]);
        CutInside += cut.Zip(box).Any(pair => Math.Abs(pair.First - pair.Second) > 1.0) ? 1 : 0;
        foreach ((double X, double Y) point in part.Where((_, index) => index % 97 == 0))
        {
            Require(DistanceTo(polygon, point) <= HalfPixel, "the polygon follows the ellipse");
        }

        foreach ((double px, double py) in polygon.Where(corner => !IsOnBorder(corner)))
        {
            Require(all.Min(point => double.Hypot(point.X - px, point.Y - py)) <= HalfPixel + spacing, "its corners lie on the ellipse");
        }

        double exact = Math.PI * major * minor * Of("inside");
        Require(Math.Abs(area - exact) <= (0.005 * exact) + 0.05, $"the area is that of the part of the ellipse: {area}, {exact}");

        bool IsOnBorder((double X, double Y) point) =>
            point.X == 0.0 || point.Y == 0.0 || point.X == image.Width || point.Y == image.Height;

        bool IsIn((double X, double Y) point)
        {
            (double right, double down) = (point.X - x, point.Y - y);
            double along = ((cos * right) + (sin * down)) / major;
            double across = ((cos * down) - (sin * right)) / minor;
            return (along * along) + (across * across) <= 1.0;
        }
    }

    private static void RequireSame(double[] box, double[] other, double tolerance, string rule)
    {
        double[] ends = [box[0], box[1], box[0] + box[2], box[1] + box[3]];
        double[] otherEnds = [other[0], other[1], other[0] + other[2], other[1] + other[3]];
        Require(
            ends.Zip(otherEnds).All(pair => Math.Abs(pair.First - pair.Second) <= tolerance),
            $"{rule}: {string.Join(' ', box)}, {string.Join(' ', other)}");
    }

    private static double[] BoxOf((double X, double Y)[] points)
    {
        (double left, double top) = (points.Min(point => point.X), points.Min(point => point.Y));
        return [left, top, points.Max(point => point.X) - left, points.Max(point => point.Y) - top];
    }

    private static double AreaOf((double X, double Y)[] corners) => 0.5 * Math.Abs(corners.Zip(
        corners.Skip(1).Append(corners[0]), (from, to) => (from.X * to.Y) - (to.X * from.Y)).Sum());

    private static double DistanceTo((double X, double Y)[] polygon, (double X, double Y) point) => Enumerable.Range(0, polygon.Length)
        .Min(index =>
        {
            ((double ax, double ay), (double bx, double by)) = (polygon[index], polygon[(index + 1) % polygon.Length]);
            (double dx, double dy) = (bx - ax, by - ay);
            double part = Math.Clamp((((point.X - ax) * dx) + ((point.Y - ay) * dy)) / ((dx * dx) + (dy * dy)), 0.0, 1.0);
            return double.Hypot(point.X - ax - (part * dx), point.Y - ay - (part * dy));
        });

    private static double[] Numbers(JsonElement array) => [.. array.EnumerateArray().Select(number => number.GetDouble())];
}
