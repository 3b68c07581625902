using Msisf.Core.Navigation;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Reads lists of landmarks in CSV with named columns: latitude and longitude in degrees with a height in m, or none for a point on the
/// terrain; or x, y, z in m.
/// </summary>
public static class LandmarkReader
{
    private const string Needed = "A list of places";

    /// <summary>Each is followed by three rays in each frame.</summary>
    public const int MostLandmarks = 1_000_000;

    /// <summary>m over or below the reference radius.</summary>
    private const double MaxHeight = 1e9;

    /// <summary>Reads a list.</summary>
    /// <param name="path">The file.</param>
    /// <param name="referenceRadius">m: heights count over it.</param>
    /// <param name="most">How many it may have.</param>
    /// <param name="given">Which columns the user names; null for none.</param>
    /// <returns>At least one.</returns>
    /// <exception cref="BadInputException">It can't be read, a value is wrong, or an identity is there twice.</exception>
    public static IReadOnlyList<Landmark> Read(
        string path, double referenceRadius, int most = MostLandmarks, ListColumns? given = null) =>
        ListTable.Read(path, Needed, reader => Read(reader, path, referenceRadius, most, given));

    /// <summary>Reads a list.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="referenceRadius">m: heights count over it.</param>
    /// <param name="most">How many it may have.</param>
    /// <param name="given">Which columns the user names; null for none.</param>
    /// <inheritdoc cref="Read(string, double, int, ListColumns)"/>
    public static IReadOnlyList<Landmark> Read(
        TextReader reader, string fileName, double referenceRadius, int most = MostLandmarks, ListColumns? given = null)
    {
        ListTable table = ListTable.Open(reader, fileName, given, header => Columns.Of(header).AreThere);
        Columns columns = Columns.Of(table.Header);
        if (table.Header.Missing is not null || !columns.AreThere)
        {
            throw table.Header.NoColumn(fileName, "latitude and longitude, nor x, y and z", "lat=COLUMN,lon=COLUMN");
        }

        List<Landmark> landmarks = [];
        Dictionary<string, int> lines = new(StringComparer.Ordinal);
        foreach (CsvRow row in table.Rows)
        {
            Landmark landmark = Of(row, columns, landmarks.Count + 1, referenceRadius);
            if (!lines.TryAdd(landmark.Identity, row.Line))
            {
                throw new BadInputException(Invariant(
                    $"{fileName}, line {row.Line}: the landmark '{landmark.Identity}' is already in line {lines[landmark.Identity]}. "
                        + $"Remove one."));
            }

            landmarks.Add(landmark);
            if (landmarks.Count > most)
            {
                throw new BadInputException(Invariant($"{fileName}: more than {most} landmarks or points. Leave some out."));
            }
        }

        return landmarks.Count > 0
            ? landmarks
            : throw new BadInputException($"{fileName}: no landmarks below the heading. Give a list.");
    }

    /// <summary>The names of a list's columns that are not used, in small letters.</summary>
    /// <param name="path">The file.</param>
    /// <param name="given">Which columns the user names; null for none.</param>
    /// <exception cref="BadInputException">It can't be read.</exception>
    public static IReadOnlyList<string> UnusedColumnsOf(string path, ListColumns? given) => ListTable.Read(path, Needed, reader =>
    {
        ListHeader header = ListTable.Open(reader, path, given, found => Columns.Of(found).AreThere).Header;
        int[] used = Columns.Of(header).All;
        return (IReadOnlyList<string>)[.. header.Names.Where((name, place) => name.Length > 0 && !used.Contains(place))];
    });

    private static Landmark Of(CsvRow row, Columns columns, int number, double referenceRadius)
    {
        string identity = row.Text(columns.Identity) ?? number.ToString(CultureInfo.InvariantCulture);
        string? name = row.Text(columns.Name);
        if (columns.HasPosition)
        {
            double limit = referenceRadius + MaxHeight;
            Vector3D position = new(
                row.Number(columns.X, -limit, limit), row.Number(columns.Y, -limit, limit), row.Number(columns.Z, -limit, limit));
            return position.Length > 0.0
                ? new Landmark(number, identity, name, position.Normalized(), position.Length - referenceRadius)
                : throw new BadInputException(Invariant(
                    $"{row.FileName}, line {row.Line}: the landmark lies in the Moon's centre. Remove it."));
        }

        SelenographicPoint place = new(
            double.DegreesToRadians(row.Number(columns.Latitude, -90.0, 90.0)),
            double.DegreesToRadians(row.Number(columns.Longitude, -360.0, 360.0)));
        bool isOnTerrain = row.Text(columns.Height) is null or "terrain";
        return new Landmark(
            number, identity, name, place.ToDirectionBodyFixed(), isOnTerrain ? null : row.Number(columns.Height, -MaxHeight, MaxHeight));
    }

    private readonly record struct Columns(
        int Identity, int Name, int Latitude, int Longitude, int Height, int X, int Y, int Z)
    {
        private static readonly string[] Metres = ["", "m"];

        public bool HasPosition => X >= 0 && Y >= 0 && Z >= 0;

        public bool AreThere => HasPosition || (Latitude >= 0 && Longitude >= 0);

        public int[] All => [Identity, Name, Latitude, Longitude, Height, X, Y, Z];

        public static Columns Of(ListHeader header) => new(
            header.PlaceOf("id", "id"), header.PlaceOf("name", "name", "featurename", "cleanfeaturename"),
            header.PlaceOf("lat", "lat", "latitude", "centerlatitude", "latdeg"),
            header.PlaceOf("lon", "lon", "long", "lng", "longitude", "centerlongitude", "londeg"),
            header.PlaceIn(Metres, "height", "height", "heightm"), header.PlaceIn(Metres, "x", "x"), header.PlaceIn(Metres, "y", "y"),
            header.PlaceIn(Metres, "z", "z"));
    }
}
