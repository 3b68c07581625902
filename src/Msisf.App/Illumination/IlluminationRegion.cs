using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Terrain;

namespace Msisf.App.Illumination;

/// <summary>
/// The cells of a region: of a polar stereographic map from 45 degrees of latitude on, else of a map whose lines and samples are degrees.
/// Immutable.
/// </summary>
/// <param name="Lines">Number of lines, from the top.</param>
/// <param name="Cell">m: width of a cell, of a polar map at the pole.</param>
/// <param name="Left">m: X of the left edge, with the pole or longitude 0 in the middle.</param>
/// <param name="Top">m: Y of the upper edge.</param>
/// <param name="Polar">The map without its offsets; null for degrees.</param>
internal sealed record IlluminationRegion(int Lines, int Samples, double Cell, double Left, double Top, PolarStereographic? Polar)
{
    private const double LowestPolarLatitude = 45.0;

    /// <summary>m: of the sphere of the models, over which degrees become metres.</summary>
    public required double Radius { get; init; }

    /// <summary>Cells.</summary>
    public int Count => Lines * Samples;

    /// <summary>PROJ's name of the projection.</summary>
    public string Proj4 => string.Create(
        CultureInfo.InvariantCulture,
        $"{(Polar is null ? "+proj=eqc +lat_ts=0 +lat_0=0 +lon_0=0"
            : Polar.IsSouth ? "+proj=stere +lat_0=-90 +lon_0=0 +k=1" : "+proj=stere +lat_0=90 +lon_0=0 +k=1")} "
            + $"+x_0=0 +y_0=0 +R={Radius:R} +units=m +no_defs");

    /// <summary>Finds the cells that are asked for.</summary>
    /// <param name="settings">The settings; without a place the finest model is the region.</param>
    /// <param name="models">The models.</param>
    /// <exception cref="UsageException">There are too many, or none.</exception>
    public static IlluminationRegion Of(IlluminationSettings settings, ITerrain models)
    {
        ITerrainGrid finest = models.Models[^1];
        double radius = models.ReferenceRadius;
        double[] place = settings.Place ?? CornersOf(finest);
        foreach (double latitude in (double[])[place[0], place[^2]])
        {
            Core.Guard.InRange(latitude, -90.0, 90.0, "The latitude of the region (degrees)");
        }

        double cell = settings.Cell ?? finest.Projection.Resolution.OnSphere(radius).MetresPerPixel;
        double middle = 0.5 * (place[0] + place[^2]);
        PolarStereographic? polar = Math.Abs(middle) >= LowestPolarLatitude ? new PolarStereographic(
            middle < 0.0, MoonConstants.ReferenceRadius / radius, 0.0, 0.0) : null;
        (double x, double y) = OnMap(polar, radius, place[0], place[1]);
        (double otherX, double otherY) = OnMap(polar, radius, place[^2], place[^1]);
        (double width, double height) = settings.Size ?? (Math.Abs(otherX - x), Math.Abs(otherY - y));
        (double centreX, double centreY) = (0.5 * (x + otherX), 0.5 * (y + otherY));
        double samples = Math.Round(width / cell);
        double lines = Math.Round(height / cell);
        if (!(samples >= 1.0 && lines >= 1.0 && samples * lines <= IlluminationOptions.MaxCells))
        {
            throw new UsageException(string.Create(
                CultureInfo.InvariantCulture,
                $"The region has {samples:R} x {lines:R} cells of {cell:R} m; 1 to {IlluminationOptions.MaxCells} cells can be asked for. "
                    + $"Choose another size or {IlluminationOptions.Cell.Name}.")).About(IlluminationOptions.Cell);
        }

        double top = centreY + (0.5 * lines * cell);
        if (polar is null && (Math.Max(top, (lines * cell) - top) > 0.5 * Math.PI * radius || samples * cell > 2.0 * Math.PI * radius))
        {
            throw new UsageException(
                "The region leads over a pole, or more than once around: on a map in degrees there is no such place. Choose another size, "
                    + $"or a {IlluminationOptions.Centre.Name} from 45 degrees of latitude on.").About(IlluminationOptions.Size);
        }

        return new IlluminationRegion(
            (int)lines, (int)samples, cell, centreX - (0.5 * samples * cell), top, polar)
        {
            Radius = radius,
        };
    }

    /// <summary>Direction of a cell's middle, body-fixed.</summary>
    public Vector3D DirectionOf(int line, int sample)
    {
        double x = Left + ((sample + 0.5) * Cell);
        double y = Top - ((line + 0.5) * Cell);
        return Polar is { } polar
            ? polar.DirectionOf(-y, x)
            : new SelenographicPoint(y / Radius, x / Radius).ToDirectionBodyFixed();
    }

    /// <summary>Directions of the cells of some lines, line by line.</summary>
    public Vector3D[] DirectionsOf(int firstLine, int endLine)
    {
        Vector3D[] directions = new Vector3D[(endLine - firstLine) * Samples];
        for (int i = 0; i < directions.Length; i++)
        {
            directions[i] = DirectionOf(firstLine + (i / Samples), i % Samples);
        }

        return directions;
    }

    /// <summary>Directions of cells spread over the region, those of its corners among them.</summary>
    public IEnumerable<Vector3D> Spread()
    {
        const int Side = 8;
        for (int i = 0; i < (Side + 1) * (Side + 1); i++)
        {
            yield return DirectionOf(
                (int)((Lines - 1) * (i / (Side + 1) / (double)Side)), (int)((Samples - 1) * (i % (Side + 1) / (double)Side)));
        }
    }

    /// <summary>Two opposite corners of the finest model, at the middles of its samples; degrees.</summary>
    private static double[] CornersOf(ITerrainGrid model)
    {
        GridWindow window = model.Window;
        if (model.IsWholeBody)
        {
            throw IlluminationSettings.NoPlace("The finest model is of the whole body, which is no one map. ");
        }

        (double lat, double lon) first = DegreesOf(window.FirstLine, window.FirstSample);
        (double lat, double lon) last = DegreesOf(window.EndLine - 1, window.EndSample - 1);
        return [first.lat, first.lon, last.lat, last.lon];

        (double Latitude, double Longitude) DegreesOf(int line, int sample)
        {
            SelenographicPoint point = SelenographicPoint.Below(model.Projection.DirectionOf(line, sample));
            return (double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude));
        }
    }

    /// <summary>m: X to the right and Y upwards, as GDAL has them.</summary>
    private static (double X, double Y) OnMap(PolarStereographic? polar, double radius, double latitudeDegrees, double longitudeDegrees)
    {
        SelenographicPoint point = new(double.DegreesToRadians(latitudeDegrees), double.DegreesToRadians(longitudeDegrees));
        if (polar is null)
        {
            return (radius * point.Longitude, radius * point.Latitude);
        }

        (double line, double sample) = polar.PixelOf(point.ToDirectionBodyFixed());
        return (sample, -line);
    }
}
