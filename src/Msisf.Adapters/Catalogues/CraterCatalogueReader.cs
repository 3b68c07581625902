using System.Globalization;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Reads catalogues of craters in CSV: those of Head et al. (2010) and Povilaitis et al. (2018) as DeepMoon has them, Robbins (2018), and
/// the IAU's list of names. Columns are known by their names; diameters are in km.
/// </summary>
public static class CraterCatalogueReader
{
    /// <summary>Craters that are kept, the largest: more than a picture can show.</summary>
    public const int MostCraters = 50_000;

    private const double MetresPerKilometre = 1000.0;

    private static readonly string[] LatitudeNames = ["lat", "latitude", "lat_elli_img", "lat_circ_img", "center latitude", "center_latitude"];

    private static readonly string[] LongitudeNames =
        ["lon", "long", "longitude", "lon_elli_img", "lon_circ_img", "center longitude", "center_longitude"];

    private static readonly string[] DiameterNames =
        ["diam_km", "diameter (km)", "diameter", "diameter_km", "diam_elli_major_img", "diam_circ_img"];

    private static readonly string[] NameNames = ["name", "feature name", "feature_name", "clean feature name", "clean_feature_name"];

    /// <summary>Reads a catalogue.</summary>
    /// <param name="path">The file.</param>
    /// <returns>The largest craters, at most <see cref="MostCraters"/>, the largest first.</returns>
    /// <exception cref="BadInputException">It can't be read, or a value is wrong; the message names file and line.</exception>
    public static IReadOnlyList<CatalogueCrater> Read(string path)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. A catalogue of craters in CSV is needed.");
        }

        return FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            using StreamReader reader = new(path, Encoding.UTF8);
            return Read(reader, path);
        });
    }

    /// <summary>Reads a catalogue.</summary>
    /// <param name="reader">The text.</param>
    /// <param name="fileName">For messages.</param>
    /// <inheritdoc cref="Read(string)"/>
    public static IReadOnlyList<CatalogueCrater> Read(TextReader reader, string fileName)
    {
        List<string> header = [.. Fields(reader.ReadLine() ?? string.Empty).Select(name => name.Trim().ToLowerInvariant())];
        int latitude = Column(LatitudeNames, "latitude");
        int longitude = Column(LongitudeNames, "longitude");
        int diameter = Column(DiameterNames, "diameter in km");
        int name = header.FindIndex(NameNames.Contains);
        PriorityQueue<CatalogueCrater, (double Diameter, int Order)> largest = new();
        int line = 1;
        while (reader.ReadLine() is { } text)
        {
            line++;
            if (text.Trim().Length == 0)
            {
                continue;
            }

            List<string> fields = Fields(text);
            string? itsName = name >= 0 && name < fields.Count && fields[name].Trim().Length > 0 ? fields[name].Trim() : null;
            CatalogueCrater crater = new(
                itsName, Number(latitude, -90.0, 90.0), Longitude(Number(longitude, -360.0, 360.0)),
                MetresPerKilometre * Number(diameter, 0.0, 1e4));
            largest.Enqueue(crater, (crater.Diameter, -line)); // of two of one size the earlier line stays
            if (largest.Count > MostCraters)
            {
                largest.Dequeue();
            }

            double Number(int column, double least, double greatest) =>
                column < fields.Count
                && double.TryParse(fields[column], NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                && number >= least && number <= greatest
                    ? number
                    : throw new BadInputException(string.Create(
                        CultureInfo.InvariantCulture,
                        $"{fileName}, line {line}, column '{header[column]}': a number from {least:R} to {greatest:R} is needed. "
                            + $"Correct or remove the line."));
        }

        CatalogueCrater[] craters = new CatalogueCrater[largest.Count];
        for (int index = craters.Length - 1; index >= 0; index--)
        {
            craters[index] = largest.Dequeue();
        }

        return craters;

        int Column(string[] names, string what)
        {
            int column = header.FindIndex(names.Contains);
            return column >= 0 ? column : throw new BadInputException(
                $"{fileName}, line 1: no column for the {what}; it may be called {string.Join(", ", names)}. Name the columns there.");
        }
    }

    private static double Longitude(double degrees) => degrees < 0.0 ? degrees + 360.0 : degrees == 360.0 ? 0.0 : degrees;

    /// <summary>The fields of a line; those in double quotes may hold commas, and a quote as two of them.</summary>
    private static List<string> Fields(string line)
    {
        List<string> fields = [];
        StringBuilder field = new();
        bool isQuoted = false;
        foreach (char letter in line)
        {
            if (letter == '"')
            {
                isQuoted = !isQuoted;
                if (isQuoted && field.Length > 0)
                {
                    field.Append('"');
                }
            }
            else if (letter == ',' && !isQuoted)
            {
                fields.Add(field.ToString());
                field.Clear();
            }
            else
            {
                field.Append(letter);
            }
        }

        fields.Add(field.ToString());
        return fields;
    }
}
