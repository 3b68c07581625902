using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Maps;
using Msisf.Core.Terrain;

namespace Msisf.App.Illumination;

/// <summary>
/// Finds the cells of a region: of a polar stereographic map from 45 degrees of latitude on, otherwise of a map of longitude and latitude.
/// Unless their size is given, they are the pixels of the model, if it has the same map. Others have their borders at multiples of their
/// size.
/// </summary>
internal sealed class IlluminationRegion
{
    private const double LowestPolarLatitude = 45.0;

    /// <summary>Part of a cell by which a border may pass the end of the map for rounding.</summary>
    private const double Rounding = 1e-6;

    private readonly IlluminationSettings _settings;
    private readonly GroundProjection _map;

    /// <summary>Two opposite corners on the map; for a middle with a size both are the middle.</summary>
    private readonly (double X, double Y) _first;
    private readonly (double X, double Y) _second;

    /// <summary>m on the ground in the region's middle for a unit of the map.</summary>
    private readonly (double X, double Y) _scale;

    /// <summary>The model whose pixels the cells are like: the finest that shows the region's middle, or the finest of all.</summary>
    private readonly ITerrainGrid _model;

    private IlluminationRegion(IlluminationSettings settings, ITerrain models)
    {
        _settings = settings;
        double[] place = settings.Place ?? CornersOf(models.Models[^1]);
        (double latitude, double otherLatitude) = (place[0], place[^2]);
        foreach (double given in (double[])[latitude, otherLatitude])
        {
            Core.Guard.InRange(given, -90.0, 90.0, "The latitude of the region (degrees)");
        }

        (double longitude, double otherLongitude) = Unwrapped(place[1], place[^1]);
        double middle = 0.5 * (latitude + otherLatitude);
        if (Math.Abs(middle) >= LowestPolarLatitude)
        {
            _map = new GroundProjection(
                MapKind.PolarStereographic, Math.CopySign(0.5 * Math.PI, middle), 0.0, models.ReferenceRadius);
            (_first, _second) = (OnPolarMap(latitude, longitude), OnPolarMap(otherLatitude, otherLongitude));
        }
        else
        {
            _map = new GroundProjection(
                MapKind.LongitudeLatitude, 0.0, double.DegreesToRadians(0.5 * (longitude + otherLongitude)), models.ReferenceRadius);
            (_first, _second) = ((longitude, latitude), (otherLongitude, otherLatitude));
        }

        double degree = double.DegreesToRadians(_map.Radius); // m along a great circle
        double polar = double.Hypot(Middle.X, Middle.Y) / (2.0 * _map.Radius);
        _scale = _map.IsInDegrees
            ? (degree * Math.Cos(double.DegreesToRadians(Middle.Y)), degree)
            : (1.0 / (1.0 + (polar * polar)), 1.0 / (1.0 + (polar * polar)));
        Vector3D direction = _map.ToDirection(Middle.X, Middle.Y)!.Value;
        _model = models.Models.LastOrDefault(model => Shows(model, direction)) ?? models.Models[^1];
    }

    private (double X, double Y) Middle => (0.5 * (_first.X + _second.X), 0.5 * (_first.Y + _second.Y));

    /// <summary>Finds the cells that are asked for.</summary>
    /// <param name="settings">The settings; without a place the finest model is the region.</param>
    /// <param name="models">The models.</param>
    /// <exception cref="UsageException">There are too many, or none.</exception>
    public static MapGrid Of(IlluminationSettings settings, ITerrain models)
    {
        IlluminationRegion region = new(settings, models);
        CellCounts cells = region.Count(settings.Cell, settings.Size);
        if (!(cells.Samples >= 1.0 && cells.Lines >= 1.0))
        {
            throw new UsageException(
                $"The region has no cell. Choose a larger one, or a smaller {IlluminationOptions.Cell.Name}.")
                .About(IlluminationOptions.Cell);
        }

        if (!cells.AreFew)
        {
            throw region.TooMany(cells);
        }

        MapGrid grid = new(
            region._map, (int)cells.Lines, (int)cells.Samples, cells.Left, cells.Bottom + (cells.Lines * cells.Height), cells.Width,
            cells.Height);
        region.RequireMap(grid);
        return grid;
    }

    /// <summary>Counts the cells.</summary>
    /// <param name="cell">m on the ground; null for the pixels of the model.</param>
    /// <param name="size">m on the ground; null for the corners.</param>
    private CellCounts Count(double? cell, (double Width, double Height)? size)
    {
        double metres = cell ?? _model.Projection.Resolution.OnSphere(_map.Radius).MetresPerPixel;
        (double width, double height, double originX, double originY) = (metres / _scale.X, metres / _scale.Y, 0.0, 0.0);
        if (cell is null && _map.IsInDegrees && _model.Projection is Equirectangular cylinder)
        {
            (width, height) = (1.0 / cylinder.PixelsPerDegree, 1.0 / cylinder.PixelsPerDegree);
        }
        else if (cell is null && !_map.IsInDegrees && _model.Projection is PolarStereographic { Turn: 0 } polar
            && polar.IsSouth == _map.Latitude < 0.0)
        {
            width = height = polar.MetresPerPixel * (_map.Radius / MoonConstants.ReferenceRadius);
            (originX, originY) = (-(polar.SampleOffset + 0.5) * width, (polar.LineOffset + 0.5) * height);
        }

        (double left, double samples) = Along(_first.X, _second.X, originX, width, size?.Width / _scale.X);
        (double bottom, double lines) = Along(_first.Y, _second.Y, originY, height, size?.Height / _scale.Y);
        if (_map.IsInDegrees && size is null)
        {
            // Corners at the map's ends: no cell leads over them for rounding.
            samples = Math.Min(samples, Math.Floor((360.0 / width) + Rounding));
            double start = Math.Max(bottom / height, Math.Ceiling((-90.0 / height) - Rounding));
            double end = Math.Min((bottom / height) + lines, Math.Floor((90.0 / height) + Rounding));
            (bottom, lines) = (start * height, end - start);
        }

        return new CellCounts(left, bottom, width, height, samples, lines);
    }

    /// <summary>Where cells begin along an axis, and how many there are.</summary>
    /// <param name="origin">A border of cells.</param>
    /// <param name="size">Size of the region around its middle; null between the corners.</param>
    private static (double Start, double Count) Along(double first, double second, double origin, double cell, double? size)
    {
        if (size is not { } length)
        {
            double low = Math.Round((Math.Min(first, second) - origin) / cell);
            double high = Math.Round((Math.Max(first, second) - origin) / cell);
            return (origin + (low * cell), high - low);
        }

        double count = Math.Round(length / cell);
        return (origin + (Math.Round(((first - origin) / cell) - (0.5 * count)) * cell), count);
    }

    /// <summary>Refuses a region that its map does not hold.</summary>
    private void RequireMap(MapGrid grid)
    {
        double right = grid.Left + (grid.Samples * grid.CellWidth);
        double bottom = grid.Top - (grid.Lines * grid.CellHeight);
        double rounding = Rounding * grid.CellHeight;
        if (_map.IsInDegrees && (Math.Max(grid.Top, -bottom) > 90.0 + rounding || right - grid.Left > 360.0 + rounding))
        {
            throw new UsageException(
                "The region leads over a pole, or more than once around: on a map in degrees there is no such place. Choose another size, "
                    + $"or a {IlluminationOptions.Centre.Name} from 45 degrees of latitude on.").About(IlluminationOptions.Size);
        }

        if (new[] { (grid.Left, grid.Top), (right, grid.Top), (grid.Left, bottom), (right, bottom) }.Any(
            corner => !_map.IsInDegrees && _map.ToDirection(corner.Item1, corner.Item2) is null))
        {
            throw OverEquator();
        }
    }

    /// <summary>The error of too many cells, which says how to get along with fewer.</summary>
    private UsageException TooMany(CellCounts cells)
    {
        (double width, double height) = (cells.Width * _scale.X, cells.Height * _scale.Y);
        double wider = RoundedUp(Math.Sqrt(width * height * cells.Samples * cells.Lines / IlluminationOptions.MaxCells));
        while (!Count(wider, _settings.Size).AreFew)
        {
            wider = RoundedUp(1.001 * wider);
        }

        int parts = 1;
        (double Width, double Height) part;
        do
        {
            parts++;
            part = (1e3 * RoundedUp(cells.Samples * width / parts / 1e3), 1e3 * RoundedUp(cells.Lines * height / parts / 1e3));
        }
        while (!Count(_settings.Cell, part).AreFew);
        return new UsageException(Invariant(
            $"The region has {cells.Samples:R} x {cells.Lines:R} cells of {width:G5} x {height:G5} m; {IlluminationOptions.MaxCells} cells "
                + $"are the limit. Take {IlluminationOptions.Cell.Name} {wider:R} or wider, or cut the region into {parts} x {parts} of "
                + $"{IlluminationOptions.Size.Name} {part.Width / 1e3:R},{part.Height / 1e3:R}."))
            .About(IlluminationOptions.Cell);
    }

    /// <summary>A number that is above 0, with three digits, not below it.</summary>
    private static double RoundedUp(double number)
    {
        int digits = 2 - (int)Math.Floor(Math.Log10(number));
        double power = Math.Pow(10.0, Math.Abs(digits));
        return digits >= 0 ? Math.Ceiling(number * power) / power : Math.Ceiling(number / power) * power;
    }

    /// <summary>
    /// Longitudes of two corners, degrees: from the first one to the east if the second is greater, or the shorter way. The middle is
    /// between -180 and 180, so that maps on both sides of longitude 0 meet there.
    /// </summary>
    private static (double First, double Second) Unwrapped(double first, double second)
    {
        double other = first - second > 180.0 ? second + 360.0 : second;
        double turns = 360.0 * Math.Floor(((0.5 * (first + other)) + 180.0) / 360.0);
        return (first - turns, other - turns);
    }

    private (double X, double Y) OnPolarMap(double latitudeDegrees, double longitudeDegrees) =>
        _map.ToMap(new SelenographicPoint(double.DegreesToRadians(latitudeDegrees), double.DegreesToRadians(longitudeDegrees))
            .ToDirectionBodyFixed()) ?? throw OverEquator();

    private static UsageException OverEquator() => new UsageException(
        "The region leads over the equator: a polar map ends there. Choose a smaller one, or another middle, below 45 degrees.")
        .About(IlluminationOptions.Size);

    private static bool Shows(ITerrainGrid model, Vector3D direction)
    {
        (double line, double sample) = model.Projection.PixelOf(direction);
        GridWindow window = model.Window;
        return line >= window.FirstLine && line <= window.EndLine - 1
            && ((double[])[sample, sample + model.Samples]).Any(at => at >= window.FirstSample - 0.5 && at <= window.EndSample - 0.5);
    }

    /// <summary>Two opposite corners of a model without its outermost pixels, in whose middles the ground ends; degrees.</summary>
    private static double[] CornersOf(ITerrainGrid model)
    {
        GridWindow window = model.Window;
        if (model.IsWholeBody)
        {
            throw IlluminationSettings.NoPlace("The finest model is of the whole body, which is no one map. ");
        }

        SelenographicPoint first = SelenographicPoint.Below(
            model.Projection.DirectionOf(window.FirstLine + 0.5, window.FirstSample + 0.5));
        SelenographicPoint last = SelenographicPoint.Below(
            model.Projection.DirectionOf(window.EndLine - 1.5, window.EndSample - 1.5));
        double turn = last.Longitude < first.Longitude ? 2.0 * Math.PI : 0.0;
        return [.. new[] { first.Latitude, first.Longitude, last.Latitude, last.Longitude + turn }.Select(double.RadiansToDegrees)];
    }

    /// <summary>Cells before it is known whether there are few enough.</summary>
    /// <param name="Left">In units of the map, as are the others but the counts.</param>
    private readonly record struct CellCounts(double Left, double Bottom, double Width, double Height, double Samples, double Lines)
    {
        public bool AreFew => Samples * Lines <= IlluminationOptions.MaxCells;
    }
}
