using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>What of the Moon a map shows, and how fine it is.</summary>
/// <param name="West">deg.</param>
/// <param name="Width">deg: 360 if it goes all around.</param>
/// <param name="South">deg.</param>
/// <param name="North">deg.</param>
/// <param name="Pixel">deg: the finer side of a pixel in the middle.</param>
/// <param name="Directions">Places all along the border, and some within: unit vectors.</param>
internal sealed record MapFootprint(
    double West, double Width, double South, double North, double Pixel, IReadOnlyList<Vector3D> Directions)
{
    /// <summary>deg: maps whose middle lies farther from the equator become polar ones, as pixels of a degree are narrow there.</summary>
    private const double PolarFrom = 60.0;

    /// <summary>deg: what reaches around the Moon farther goes all around.</summary>
    private const double Widest = 355.0;

    /// <summary>px/deg: from here on the resolution of a part is a multiple of a power of two, to be halved for levels of detail.</summary>
    private const double FinestAnyNumber = 1024.0;

    /// <summary>Places along a side of the map.</summary>
    private const int PlacesASide = 256;

    /// <summary>Places within, along a side.</summary>
    private const int PlacesWithin = 64;

    /// <summary>px: that of a polar map of half the Moon at the finest scale.</summary>
    private const double MostSide = 1 << 23;

    /// <summary>deg: latitudes that are rounded beyond a pole.</summary>
    private const double PastPole = 1e-6;

    /// <summary>px: a border so near to one of the grid's pixels is that.</summary>
    private const double OnPixel = 1e-3;

    /// <summary>Relative: a resolution that is rounded is not made finer.</summary>
    private const double SameResolution = 1e-6;

    /// <summary>The footprint of a map.</summary>
    /// <returns>Null if nothing of it lies on the Moon.</returns>
    public static MapFootprint? Of(MapPlane plane)
    {
        (double right, double bottom) = (plane.Width - 0.5, plane.Height - 0.5);
        List<(double Column, double Row)> places = [];
        for (int i = 0; i <= PlacesASide; i++)
        {
            (double column, double row) =
                (-0.5 + ((right + 0.5) * i / PlacesASide), -0.5 + ((bottom + 0.5) * i / PlacesASide));
            places.AddRange([(column, -0.5), (column, bottom), (-0.5, row), (right, row)]);
        }

        int borderPlaces = places.Count;
        for (int i = 1; i < PlacesWithin; i++)
        {
            for (int j = 1; j < PlacesWithin; j++)
            {
                places.Add((-0.5 + ((right + 0.5) * j / PlacesWithin), -0.5 + ((bottom + 0.5) * i / PlacesWithin)));
            }
        }

        (double[] longitudes, double[] latitudes) = plane.ToDegrees(places);
        int[] known = [.. Enumerable.Range(0, places.Count).Where(i => Math.Abs(latitudes[i]) <= 90.0 + PastPole)];
        if (known.Length == 0 || PixelOf(plane) is not (> 0.0 and double pixel))
        {
            return null;
        }

        // A disc has no border that lies on the Moon: its places within stop short of its rim by up to the step between them.
        double beyond = known.Count(i => i < borderPlaces) < borderPlaces ? 1.0 / PlacesWithin : 0.0;
        (double south, double north) = (known.Min(i => latitudes[i]), known.Max(i => latitudes[i]));
        double margin = beyond * (north - south);
        (bool hasSouth, bool hasNorth) = (Holds(plane, -90.0), Holds(plane, 90.0));
        south = hasSouth ? -90.0 : Math.Max(south - margin, -90.0);
        north = hasNorth ? 90.0 : Math.Min(north + margin, 90.0);
        (double west, double width) = plane.IsRing || hasSouth || hasNorth
            ? (0.0, 360.0)
            : Span([.. known.Select(i => longitudes[i])], beyond);
        return new MapFootprint(west, width, south, north, pixel, [.. known.Select(i => new SelenographicPoint(
            double.DegreesToRadians(latitudes[i]), double.DegreesToRadians(longitudes[i])).ToDirectionBodyFixed())]);
    }

    /// <summary>The grid on which the map is brought, and the part that it has of it.</summary>
    /// <returns>Null if the pixels are too small.</returns>
    public GeoTiffPlacement? Placement(MapPlane plane) => Math.Abs(0.5 * (South + North)) > PolarFrom ? Polar(plane) : Cylindrical(plane);

    private GeoTiffPlacement? Polar(MapPlane plane)
    {
        double scale = double.DegreesToRadians(Pixel) * MoonConstants.ReferenceRadius;
        PolarStereographic pole = new(South + North < 0.0, scale, 0.0, 0.0);
        (double Line, double Sample)[] pixels = [.. Directions.Select(pole.PixelOf)];
        (double line, double sample) =
            (Math.Floor(pixels.Min(pixel => pixel.Line) + 0.5), Math.Floor(pixels.Min(pixel => pixel.Sample) + 0.5));
        (double lines, double samples) =
            (Math.Ceiling(pixels.Max(pixel => pixel.Line) + 0.5) - line, Math.Ceiling(pixels.Max(pixel => pixel.Sample) + 0.5) - sample);
        bool isRead = scale is >= PolarLabel.MinScale and <= PolarLabel.MaxScale && Math.Max(lines, samples) < MostSide;
        PolarStereographic placed = pole with { LineOffset = -line, SampleOffset = -sample };
        return isRead && placed.Holds((int)lines, (int)samples)
            ? new GeoTiffPlacement(placed, new GridWindow(0, (int)Math.Max(lines, 2.0), 0, (int)Math.Max(samples, 2.0)), plane.Radius)
            : null;
    }

    private GeoTiffPlacement? Cylindrical(MapPlane plane)
    {
        // The whole Moon is seen from afar: its resolution is halved often. It becomes at most an eighth finer for that, a part a 64th.
        bool isRing = Width > Widest;
        double resolution = Math.Ceiling((1.0 / Pixel) - (SameResolution / Pixel));
        int finer = isRing ? 3 : 6;
        double step = isRing || resolution >= FinestAnyNumber ? Math.ScaleB(1.0, Math.ILogB(resolution) - finer) : 1.0;
        resolution = step > 1.0 ? Math.Ceiling(resolution / step) * step : resolution;
        if (!(resolution <= GeoTiffPlacement.MaxResolution))
        {
            return null;
        }

        int turn = 360 * (int)resolution;
        int firstLine = Math.Max((int)Math.Floor(((90.0 - North) * resolution) + OnPixel), 0);
        int endLine = Math.Min((int)Math.Ceiling(((90.0 - South) * resolution) - OnPixel), turn / 2);
        int first = (int)Math.Floor((West * resolution) + OnPixel);
        int end = (int)Math.Ceiling(((West + Width) * resolution) - OnPixel);
        int moved = ((first % turn) + turn) % turn;
        GridWindow window = isRing || end - first >= turn
            ? new GridWindow(firstLine, endLine, 0, turn)
            : new GridWindow(firstLine, endLine, moved, moved + end - first);
        return window is { Lines: > 1, Samples: > 1 }
            ? new GeoTiffPlacement(new Equirectangular((int)resolution), window, plane.Radius)
            : null;
    }

    /// <summary>West and width of the least range that holds all longitudes, deg.</summary>
    /// <param name="beyond">How much farther it reaches on both sides, as a part of its width.</param>
    private static (double West, double Width) Span(double[] longitudes, double beyond)
    {
        double[] sorted = [.. longitudes.Select(longitude => longitude - (360.0 * Math.Floor(longitude / 360.0))).Order()];
        (double west, double gap) = (sorted[0], sorted[0] + 360.0 - sorted[^1]);
        for (int i = 1; i < sorted.Length; i++)
        {
            (west, gap) = sorted[i] - sorted[i - 1] > gap ? (sorted[i], sorted[i] - sorted[i - 1]) : (west, gap);
        }

        double width = 360.0 - gap;
        return (west - (beyond * width), width * (1.0 + (2.0 * beyond)));
    }

    private static bool Holds(MapPlane plane, double latitude)
    {
        const double OnBorder = 0.05; // px
        (double[] column, double[] row) = ([plane.MiddleLongitude], [latitude]);
        plane.ToPixels(column, row);
        return row[0] >= -0.5 - OnBorder && row[0] <= plane.Height - 0.5 + OnBorder
            && (plane.IsCylindrical ? plane.IsRing : column[0] >= -0.5 && column[0] <= plane.Width - 0.5);
    }

    /// <summary>deg: the finer side of a pixel in the middle of the map; null if that is not on the Moon.</summary>
    private static double? PixelOf(MapPlane plane)
    {
        (double column, double row) = (Math.Floor(0.5 * (plane.Width - 1)), Math.Floor(0.5 * (plane.Height - 1)));
        (double[] longitudes, double[] latitudes) = plane.ToDegrees([(column, row), (column + 1.0, row), (column, row + 1.0)]);
        if (latitudes.Any(double.IsNaN))
        {
            return null;
        }

        if (plane.IsCylindrical)
        {
            double down = latitudes[0] - latitudes[2];
            return Math.Abs(latitudes[0]) > PolarFrom ? down : Math.Min(plane.ColumnDegrees, down);
        }

        Vector3D[] directions = [.. latitudes.Select((latitude, i) => new SelenographicPoint(
            double.DegreesToRadians(latitude), double.DegreesToRadians(longitudes[i])).ToDirectionBodyFixed())];
        return double.RadiansToDegrees(Math.Min(
            Vector3D.AngleBetween(directions[0], directions[1]), Vector3D.AngleBetween(directions[0], directions[2])));
    }
}
