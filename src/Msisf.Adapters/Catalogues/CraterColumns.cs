using Msisf.Core.Navigation;

namespace Msisf.Adapters.Catalogues;

/// <summary>Finds the columns of a catalogue of craters by their names, and reads a crater from a line.</summary>
internal sealed class CraterColumns
{
    private const double MetresPerKilometre = 1000.0;

    private static readonly string[] Kilometres = ["", "km", "kilometer", "kilometers", "kilometre", "kilometres"];

    private static readonly string[] Metres = ["m", "meter", "meters", "metre", "metres"];

    private static readonly string[] Latitudes =
        ["latelliimg", "latcircimg", "lat", "latitude", "centerlatitude", "centrelatitude", "centerlat", "latdeg", "latitudedeg", "clat"];

    private static readonly string[] Longitudes =
    [
        "lonelliimg", "loncircimg", "lon", "long", "longitude", "centerlongitude", "centrelongitude", "centerlon", "londeg",
        "longitudedeg", "clon", "lng",
    ];

    private static readonly string[] Diameters =
        ["diamellimajorimg", "diamcircimg", "diamkm", "diameter", "diameterkm", "majorkm", "diam", "dkm"];

    private readonly int[] _latitude;
    private readonly int[] _longitude;
    private readonly int[] _diameter;
    private readonly double _unit;
    private readonly int _minor;
    private readonly int _angle;
    private readonly int _name;
    private readonly int _identity;
    private readonly int[] _errors;

    /// <summary>Finds the columns.</summary>
    /// <param name="header">The names of the columns.</param>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">A column is missing.</exception>
    public CraterColumns(ListHeader header, string fileName)
    {
        _latitude = Required("the latitude", All("lat", Latitudes));
        _longitude = Required("the longitude", All("lon", Longitudes));
        int inMetres = InMetres(header);
        int[] inKilometres = Kilometre(header);
        _unit = inKilometres.Length > 0 ? 1.0 : 1.0 / MetresPerKilometre;
        _diameter = Required("the diameter in km", inKilometres.Length > 0 ? inKilometres : inMetres >= 0 ? [inMetres] : []);
        _minor = header.PlaceIn(Kilometres, "minor_km", "diamelliminorimg", "minorkm");
        _angle = header.PlaceOf("angle_deg", "diamelliangleimg", "angledeg");
        _name = header.PlaceOf("name", "name", "featurename", "cleanfeaturename", "cratername");
        _identity = header.PlaceOf("id", "craterid", "id");
        _errors =
        [
            header.PlaceOf(string.Empty, "latellisdimg", "latsd"), header.PlaceOf(string.Empty, "lonellisdimg", "lonsd"),
            header.PlaceOf(string.Empty, "diamellimajorsdimg", "diamcircsdimg", "diamkmsd", "majorkmsd"),
            header.PlaceOf(string.Empty, "diamelliminorsdimg", "minorkmsd"),
            header.PlaceOf(string.Empty, "diamellianglesdimg", "angledegsd"),
        ];

        int[] All(string key, string[] names) => Places(header, key, ListHeader.UnitsOfAngles, names);

        int[] Required(string what, int[] places) => places.Length > 0 && header.Missing is null
            ? places
            : throw header.NoColumn(fileName, what, "lat=COLUMN,lon=COLUMN,diam_km=COLUMN");
    }

    /// <summary>Whether columns are those of a catalogue of craters.</summary>
    public static bool AreIn(ListHeader header) => header.PlaceOf("lat", Latitudes) >= 0 && header.PlaceOf("lon", Longitudes) >= 0
        && (Kilometre(header).Length > 0 || InMetres(header) >= 0);

    /// <summary>Reads a crater.</summary>
    /// <param name="row">The line.</param>
    /// <param name="number">Number of the crater, from 1.</param>
    /// <param name="maxDiameter">m: no crater is larger.</param>
    /// <exception cref="BadInputException">A value is wrong.</exception>
    public Crater Read(CsvRow row, int number, double maxDiameter)
    {
        // Robbins's ellipse is missing where the rim has too few points; then the circle stands for it.
        int column = Array.FindIndex(_diameter, place => row.HasNumber(place));
        bool isEllipse = column <= 0 && row.HasNumber(_minor);
        double major = Diameter(Of(_diameter, column), _unit);
        double minor = isEllipse ? Diameter(_minor, 1.0) : major;
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

        double Diameter(int place, double unit)
        {
            const string more = ", above 0";
            double limit = maxDiameter / MetresPerKilometre;
            double kilometres = unit * row.Number(place, 0.0, limit / unit, more);
            return kilometres > 0.0 ? MetresPerKilometre * kilometres : throw row.Wrong(place, 0.0, limit / unit, more);
        }

        CraterErrors? Errors(bool ofEllipse) => Array.TrueForAll(_errors[..3], place => row.HasNumber(place))
            ? new CraterErrors(
                Error(0, 180.0), Error(1, 360.0), MetresPerKilometre * Error(2, maxDiameter),
                ofEllipse ? MetresPerKilometre * Error(3, maxDiameter) : 0.0, ofEllipse ? Error(4, 360.0) : 0.0)
            : null;

        double Error(int which, double greatest) => _errors[which] < 0 ? 0.0 : row.Number(_errors[which], 0.0, greatest);
    }

    /// <summary>Picks, among columns for the same value, the one of the diameter's form: Robbins's ellipses, or circles.</summary>
    private static int Of(int[] places, int column) => places[Math.Clamp(column, 0, places.Length - 1)];

    private static double EastLongitude(double degrees)
    {
        double east = degrees < 0.0 ? degrees + 360.0 : degrees;
        return east >= 360.0 ? 0.0 : east;
    }

    private static int[] Kilometre(ListHeader header) => header.PlaceOf("diam_m") >= 0 ? []
        : [
            .. Places(header, "diam_km", Kilometres, Diameters), .. Places(header, "major_km", Kilometres, []),
            .. Places(header, "diam_km", Kilometres[1..], ["d"]),
        ];

    private static int InMetres(ListHeader header) =>
        header.PlaceIn(Metres, "diam_m", "diameter", "diam", "d") is >= 0 and var place ? place
            : header.PlaceIn(Kilometres[..1], "diam_m", "diamm", "diameterm", "dm");

    /// <summary>The place that the user names, or those of all columns for something, in the order of the names.</summary>
    private static int[] Places(ListHeader header, string key, string[] units, string[] names) =>
        header.PlaceOf(key) is >= 0 and var given
            ? [given]
            : [.. names.Select(name => header.PlaceIn(units, key, name)).Where(place => place >= 0)];
}
