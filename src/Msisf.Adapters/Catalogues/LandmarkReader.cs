using System.Text;
using Msisf.Core.Navigation;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Reads lists of landmarks in CSV with named columns: latitude and longitude in degrees with a height in m, or none for a point on the
/// terrain; or x, y, z in m.
/// </summary>
public static class LandmarkReader
{
    /// <summary>Each is followed by three rays in each frame.</summary>
    public const int MostLandmarks = 1_000_000;

    /// <summary>m over or below the reference radius.</summary>
    private const double MaxHeight = 1e9;

    /// <summary>Reads a list.</summary>
    /// <param name="path">The file.</param>
    /// <param name="referenceRadius">m: heights count over it.</param>
    /// <param name="most">How many it may have.</param>
    /// <returns>At least one.</returns>
    /// <exception cref="BadInputException">It can't be read, a value is wrong, or an identity is there twice.</exception>
    public static IReadOnlyList<Landmark> Read(string path, double referenceRadius, int most = MostLandmarks) => !File.Exists(path)
        ? throw new BadInputException(
            $"{path}: {(Directory.Exists(path) ? "is a folder" : "there is no such file")}. A list of places in CSV is needed.")
        : FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using StreamReader reader = new(path, Encoding.UTF8);
            return Read(reader, path, referenceRadius, most);
        });

    /// <summary>Reads a list.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="referenceRadius">m: heights count over it.</param>
    /// <param name="most">How many it may have.</param>
    /// <inheritdoc cref="Read(string, double, int)"/>
    public static IReadOnlyList<Landmark> Read(TextReader reader, string fileName, double referenceRadius, int most = MostLandmarks)
    {
        IReadOnlyList<string> header = CsvRow.HeaderOf(reader);
        Columns columns = new(
            CsvRow.PlaceOf(header, "id"), CsvRow.PlaceOf(header, "name"), CsvRow.PlaceOf(header, "lat", "latitude"),
            CsvRow.PlaceOf(header, "lon", "long", "longitude"), CsvRow.PlaceOf(header, "height", "height_m"), CsvRow.PlaceOf(header, "x"),
            CsvRow.PlaceOf(header, "y"), CsvRow.PlaceOf(header, "z"));
        if (!columns.HasPosition && (columns.Latitude < 0 || columns.Longitude < 0))
        {
            throw new BadInputException(
                $"{fileName}, line 1: no columns lat and lon, nor x, y and z, which say where the landmarks are. Name the columns there.");
        }

        List<Landmark> landmarks = [];
        Dictionary<string, int> lines = new(StringComparer.Ordinal);
        foreach (CsvRow row in CsvRow.Of(reader, fileName, header))
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

    /// <summary>The names of a list's columns, in small letters.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="BadInputException">It can't be read.</exception>
    public static IReadOnlyList<string> ColumnsOf(string path) => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        using StreamReader reader = new(path, Encoding.UTF8);
        return CsvRow.HeaderOf(reader);
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
        public bool HasPosition => X >= 0 && Y >= 0 && Z >= 0;
    }
}
