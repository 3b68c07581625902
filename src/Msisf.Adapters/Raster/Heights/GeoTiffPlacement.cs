using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Where the pixels of a GeoTIFF lie on the Moon.</summary>
/// <param name="Projection">The grid of which the image is a part.</param>
/// <param name="Window">That part; lines and samples count in the grid.</param>
/// <param name="SphereRadius">m: the sphere over which the heights are.</param>
internal sealed record GeoTiffPlacement(MapProjection Projection, GridWindow Window, double SphereRadius)
{
    /// <summary>m: spheres of the Moon lie between these.</summary>
    private static readonly (double Min, double Max) MoonRadii = (1_720_000.0, 1_760_000.0);

    /// <summary>Relative: pixels whose width and height differ less are square; the same for whole numbers of samples a degree.</summary>
    private const double SameScale = 1e-6;

    /// <summary>Relative: MAP_SCALE of labels has four digits and more.</summary>
    private const double RoundedScale = 1e-4;

    /// <summary>px: how far the pixels may be from those of the whole Moon's grid.</summary>
    private const double SamePixel = 1e-3;

    /// <summary>px/deg: that of pixels of <see cref="PolarLabel.MinScale"/>, for which the lattice is fine enough.</summary>
    public static readonly double MaxResolution =
        Math.Floor(double.DegreesToRadians(MoonConstants.ReferenceRadius) / PolarLabel.MinScale);

    /// <summary>Reads the placement.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="width">Pixels of a row.</param>
    /// <param name="height">Number of rows.</param>
    /// <param name="transform">GDAL's six numbers; null if there are none.</param>
    /// <param name="projection">The projection; null if there is none.</param>
    /// <returns>The placement; null if the pixels lie on the Moon, but on no grid that is read.</returns>
    /// <param name="hasRoundedScale">
    /// Whether the size of a pixel is rounded and its place is not, as in labels of PDS3: these count both from the projection's origin.
    /// </param>
    /// <exception cref="BadInputException">It is incomplete, of another body, or out of bounds.</exception>
    public static GeoTiffPlacement? Find(
        string path, int width, int height, double[]? transform, string? projection, bool hasRoundedScale = false)
    {
        if (projection is null)
        {
            throw new BadInputException(
                $"{path}: has no coordinate system. If its columns are degrees of longitude, write it anew with gdal_translate "
                    + $"-a_srs '+proj=longlat +R=1737400' -a_ullr WEST NORTH EAST SOUTH; if it is a map, with the projection of that map.");
        }

        ProjText proj = new(projection);
        if (proj.Unread is { } unread)
        {
            throw new BadInputException(
                $"{path}: its coordinate system has {unread}, which is not read. If it means nothing for this map, write it anew without: "
                    + $"gdal_translate -a_srs '{proj.WithoutUnread}'.");
        }

        if (proj.Radius is not double radius || !IsMoonRadius(radius))
        {
            throw new BadInputException(
                $"{path}: its coordinate system ({proj}) is not one on a sphere of the Moon (R = 1737400 m). Take a lunar model, or "
                    + $"correct it with gdal_translate -a_srs.");
        }

        if (transform is not [double left, > 0.0 and double across, 0.0, double top, 0.0, < 0.0 and double down]
            || width < 2 || height < 2)
        {
            throw new BadInputException(
                $"{path}: has no place on the map, less than 2 x 2 pixels, or its rows do not run from west to east and from the top down. "
                    + $"Rewrite it with gdalwarp.");
        }

        return proj.Name switch
        {
            "stere" => Polar(path, proj, radius, (left, top, across, -down), (width, height)),
            "eqc" or "longlat" => Cylindrical(proj, radius, (left, top, across, -down), (width, height), hasRoundedScale),
            _ => null,
        };
    }

    /// <summary>Whether a sphere is one of the Moon, m.</summary>
    public static bool IsMoonRadius(double radius) => radius >= MoonRadii.Min && radius <= MoonRadii.Max;

    private static GeoTiffPlacement? Polar(
        string path, ProjText proj, double radius, (double Left, double Top, double Across, double Down) map, (int Width, int Height) size)
    {
        double latitude = proj.Number("lat_0") ?? double.NaN;
        double unit = proj.MetresPerUnit;
        if (Math.Abs(latitude) != 90.0 || proj.MiddleLongitude != 0.0 || double.IsNaN(unit)
            || Math.Abs((map.Down / map.Across) - 1.0) > SameScale)
        {
            return null;
        }

        // A map that is true to scale at another latitude is one that is smaller by this factor.
        double factor = proj.Number("k") ?? proj.Number("k_0")
            ?? (proj.Number("lat_ts") is double trueLatitude
                ? 0.5 * (1.0 + Math.Sin(double.DegreesToRadians(Math.Abs(trueLatitude))))
                : 1.0);
        double scale = map.Across * unit / factor * (MoonConstants.ReferenceRadius / radius);
        PolarStereographic projection = new(
            latitude < 0.0,
            scale,
            ((map.Top - ((proj.Number("y_0") ?? 0.0) / unit)) / map.Down) - 0.5,
            ((((proj.Number("x_0") ?? 0.0) / unit) - map.Left) / map.Across) - 0.5);
        if (!(scale is >= PolarLabel.MinScale and <= PolarLabel.MaxScale) || !projection.Holds(size.Height, size.Width))
        {
            throw new BadInputException(Invariant(
                $"{path}: pixels of {scale:R} m, or a map that reaches farther than {MoonConstants.ReferenceRadius / 1000.0:R} km from the "
                    + $"pole; {PolarLabel.MinScale:R} to {PolarLabel.MaxScale:R} m are read."));
        }

        return new GeoTiffPlacement(projection, new GridWindow(0, size.Height, 0, size.Width), radius);
    }

    private static GeoTiffPlacement? Cylindrical(
        ProjText proj, double radius, (double Left, double Top, double Across, double Down) map, (int Width, int Height) size,
        bool hasRoundedScale)
    {
        // Degrees a map unit.
        double unit = proj.Name == "longlat" ? 1.0 : double.RadiansToDegrees(proj.MetresPerUnit / radius);
        double resolution = Math.Round(1.0 / (map.Across * unit));
        if (hasRoundedScale && Math.Abs((map.Across * unit * resolution) - 1.0) <= RoundedScale)
        {
            double exact = 1.0 / (resolution * unit);
            map = (map.Left / map.Across * exact, map.Top / map.Down * exact, exact, map.Down / map.Across * exact);
        }

        // False eastings and northings are in metres, whatever the unit of the map is.
        double west = ((map.Left - ((proj.Number("x_0") ?? 0.0) / proj.MetresPerUnit)) * unit) + proj.MiddleLongitude;
        double firstLine = (90.0 - ((map.Top - ((proj.Number("y_0") ?? 0.0) / proj.MetresPerUnit)) * unit)) * resolution;
        double firstSample = (west - (360.0 * Math.Floor(west / 360.0))) * resolution;
        double turn = 360.0 * resolution;
        firstSample = Math.Abs(firstSample - turn) <= SamePixel ? 0.0 : firstSample;
        bool isRing = size.Width == turn;
        if ((proj.Number("lat_ts") ?? 0.0) != 0.0 || (proj.Number("lat_0") ?? 0.0) != 0.0
            || !(resolution >= 1.0 && resolution <= MaxResolution)
            || Math.Abs((map.Across * unit * resolution) - 1.0) > SameScale || Math.Abs((map.Down * unit * resolution) - 1.0) > SameScale
            || Math.Abs(firstLine - Math.Round(firstLine)) > SamePixel || Math.Abs(firstSample - Math.Round(firstSample)) > SamePixel
            || Math.Round(firstLine) < 0.0 || Math.Round(firstLine) + size.Height > 180.0 * resolution
            || size.Width > turn)
        {
            return null;
        }

        GridWindow window = isRing
            ? new GridWindow((int)Math.Round(firstLine), (int)Math.Round(firstLine) + size.Height, 0, size.Width)
            : new GridWindow(
                (int)Math.Round(firstLine), (int)Math.Round(firstLine) + size.Height, (int)Math.Round(firstSample),
                (int)Math.Round(firstSample) + size.Width);
        return new GeoTiffPlacement(new Equirectangular((int)resolution), window, radius)
        {
            RingStart = isRing ? (int)Math.Round(firstSample) : 0,
        };
    }

    /// <summary>Sample of the grid at which the first pixel of a map that goes all around lies.</summary>
    public int RingStart { get; private init; }

    /// <summary>Whether the map goes all around.</summary>
    public bool IsRing => Projection is Equirectangular map && Window.Samples == 360 * map.PixelsPerDegree;

    /// <summary>The file's column of a sample, both from 0; of a map that goes all around samples are those of the grid.</summary>
    /// <param name="sample">From the window's first one.</param>
    public int ColumnOf(int sample) => sample >= RingStart ? sample - RingStart : sample - RingStart + Window.Samples;
}

/// <summary>A map projection in PROJ's form: "+proj=stere +lat_0=-90 +R=1737400 +units=m".</summary>
internal sealed class ProjText(string text)
{
    private const string Bound = "towgs84";

    private readonly Dictionary<string, string> _words = text
        .Split(' ', StringSplitOptions.RemoveEmptyEntries)
        .Select(word => word.TrimStart('+').Split('=', 2))
        .GroupBy(pair => pair[0], StringComparer.Ordinal)
        .ToDictionary(group => group.Key, group => group.First() is [_, var value] ? value : string.Empty, StringComparer.Ordinal);

    /// <summary>The projection's name.</summary>
    public string Name => _words.GetValueOrDefault("proj", string.Empty);

    /// <summary>m: the radius of the sphere; null for an ellipsoid or a datum by name.</summary>
    public double? Radius => Number("R") ?? (Number("a") is double a && a == Number("b") ? a : null);

    /// <summary>m: length of a unit of map coordinates; NaN of one that is not known.</summary>
    public double MetresPerUnit => Number("to_meter") ?? (_words.GetValueOrDefault("units", "m") switch
    {
        "m" => 1.0,
        "km" => 1000.0,
        "cm" => 0.01,
        "mm" => 0.001,
        "ft" => 0.3048,
        "us-ft" => 1200.0 / 3937.0,
        "yd" => 0.9144,
        "mi" => 1609.344,
        "kmi" => 1852.0,
        _ => double.NaN,
    });

    /// <summary>deg: the longitude from which map coordinates count, from that of the body.</summary>
    public double MiddleLongitude => (Number("lon_0") ?? 0.0) + (Number("pm") ?? 0.0);

    /// <summary>The first word that changes where the map lies in a way that is not read; null if there is none.</summary>
    public string? Unread => _words.Where(IsUnread).Select(word => $"+{word.Key}={word.Value}").FirstOrDefault();

    /// <summary>The text without what <see cref="Unread"/> names.</summary>
    public string WithoutUnread => string.Join(' ', _words.Where(word => !IsUnread(word)).Select(TextOf));

    /// <summary>The text for PROJ: without the way to a datum of the Earth, if that way goes nowhere.</summary>
    public string ForProj => string.Join(' ', _words.Where(word => word.Key != Bound).Select(TextOf));

    /// <summary>A number by its name; null if it is missing or no number.</summary>
    public double? Number(string name) => _words.TryGetValue(name, out string? value) ? Parse(value) : null;

    /// <summary>The text.</summary>
    public override string ToString() => text.Trim();

    /// <summary>
    /// A way to the Earth's datum that moves anything, grids of shifts, axes to the west or south, angles in other units than degrees, and
    /// a prime meridian by its name.
    /// </summary>
    private bool IsUnread(KeyValuePair<string, string> word) => word.Key switch
    {
        Bound => word.Value.Split(',').Any(number => !(Parse(number) == 0.0)),
        "nadgrids" or "geoidgrids" or "angular_unit" => true,
        "axis" => word.Value != "enu",
        "pm" => Parse(word.Value) is null && word.Value != "greenwich",
        _ => false,
    };

    private static string TextOf(KeyValuePair<string, string> word) =>
        word.Value.Length == 0 ? $"+{word.Key}" : $"+{word.Key}={word.Value}";

    private static double? Parse(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;
}
