using Msisf.Core.Navigation;

namespace Msisf.Adapters.Catalogues;

/// <summary>Finds the columns of a catalogue of craters by their names, and reads a crater from a line.</summary>
internal sealed class CraterColumns
{
    private const double MetresPerKilometre = 1000.0;

    private readonly string _fileName;
    private readonly IReadOnlyList<string> _header;
    private readonly int[] _latitude;
    private readonly int[] _longitude;
    private readonly int[] _diameter;
    private readonly int _minor;
    private readonly int _angle;
    private readonly int _name;
    private readonly int _identity;
    private readonly int[] _errors;

    /// <summary>Finds the columns.</summary>
    /// <param name="header">The names of the columns, in small letters.</param>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">A column is missing.</exception>
    public CraterColumns(IReadOnlyList<string> header, string fileName)
    {
        _fileName = fileName;
        _header = header;
        _latitude = Required(
            "latitude", ["lat_elli_img", "lat_circ_img", "lat", "latitude", "center latitude", "center_latitude"]);
        _longitude = Required(
            "longitude", ["lon_elli_img", "lon_circ_img", "lon", "long", "longitude", "center longitude", "center_longitude"]);
        _diameter = Required(
            "diameter in km",
            ["diam_elli_major_img", "diam_circ_img", "diam_km", "diameter (km)", "diameter", "diameter_km", "major_km"]);
        _minor = Place(["diam_elli_minor_img", "minor_km"]);
        _angle = Place(["diam_elli_angle_img", "angle_deg"]);
        _name = Place(["name", "feature name", "feature_name", "clean feature name", "clean_feature_name"]);
        _identity = Place(["crater_id", "id"]);
        _errors =
        [
            Place(["lat_elli_sd_img", "lat_sd"]), Place(["lon_elli_sd_img", "lon_sd"]),
            Place(["diam_elli_major_sd_img", "diam_circ_sd_img", "diam_km_sd", "major_km_sd"]),
            Place(["diam_elli_minor_sd_img", "minor_km_sd"]), Place(["diam_elli_angle_sd_img", "angle_deg_sd"]),
        ];
    }

    /// <summary>Reads a crater.</summary>
    /// <param name="row">The line.</param>
    /// <param name="number">Of the crater, from 1.</param>
    /// <param name="maxDiameter">m: no crater is larger.</param>
    /// <exception cref="BadInputException">A value is wrong.</exception>
    public Crater Read(CsvRow row, int number, double maxDiameter)
    {
        // Robbins's ellipse is missing where the rim has too few points; then the circle stands for it.
        int column = Array.FindIndex(_diameter, place => row.HasNumber(place));
        bool isEllipse = column <= 0 && row.HasNumber(_minor);
        double major = Diameter(Of(_diameter, column));
        double minor = isEllipse ? Diameter(_minor) : major;
        double angle = isEllipse && _angle >= 0 ? row.Number(_angle, -360.0, 360.0) : 0.0;
        if (minor > major)
        {
            (major, minor, angle) = (minor, major, angle + 90.0);
        }

        return new Crater(
            number,
            row.Text(_identity) ?? number.ToString(CultureInfo.InvariantCulture),
            row.Text(_name),
            row.Number(Of(_latitude, column), -90.0, 90.0),
            EastLongitude(row.Number(Of(_longitude, column), -360.0, 360.0)),
            major)
        {
            MinorDiameter = minor,
            AngleDegrees = angle,
            Errors = Errors(isEllipse),
        };

        double Diameter(int place)
        {
            const string more = ", above 0";
            double limit = maxDiameter / MetresPerKilometre;
            double kilometres = row.Number(place, 0.0, limit, more);
            return kilometres > 0.0 ? MetresPerKilometre * kilometres : throw row.Wrong(place, 0.0, limit, more);
        }

        CraterErrors? Errors(bool ofEllipse) => Array.TrueForAll(_errors[..3], place => row.HasNumber(place))
            ? new CraterErrors(
                Error(0, 180.0), Error(1, 360.0), MetresPerKilometre * Error(2, maxDiameter),
                ofEllipse ? MetresPerKilometre * Error(3, maxDiameter) : 0.0, ofEllipse ? Error(4, 360.0) : 0.0)
            : null;

        double Error(int which, double greatest) => _errors[which] < 0 ? 0.0 : row.Number(_errors[which], 0.0, greatest);
    }

    /// <summary>Of columns for the same the one of the same form as the diameter's: Robbins's ellipses, or circles.</summary>
    private static int Of(int[] places, int column) => places[Math.Clamp(column, 0, places.Length - 1)];

    private static double EastLongitude(double degrees)
    {
        double east = degrees < 0.0 ? degrees + 360.0 : degrees;
        return east >= 360.0 ? 0.0 : east;
    }

    /// <summary>The places of all columns for something, in the order of the names.</summary>
    private int[] Required(string what, string[] names)
    {
        int[] places = [.. names.Select(name => CsvRow.PlaceOf(_header, name)).Where(place => place >= 0)];
        return places.Length > 0 ? places : throw new BadInputException(
            $"{_fileName}, line 1: no column for the {what}; it may be called {string.Join(", ", names)}. Name the columns there.");
    }

    private int Place(string[] names) => CsvRow.PlaceOf(_header, names);
}
