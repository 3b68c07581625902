using Msisf.Core.Sky;

namespace Msisf.Adapters.Catalogues;

/// <summary>What the numbers of a star may be; other units than degrees and mas are found by it.</summary>
internal static class StarLimits
{
    /// <summary>mas a year: Barnard's star has 10 400.</summary>
    public const double Motion = 15_000.0;

    /// <summary>mas: the nearest has 770; measured ones may be negative.</summary>
    public const double Parallax = 1_000.0;

    public const double Brightest = -2.0;

    public const double Faintest = 30.0;

    /// <summary>B - V: noise of faint stars reaches far.</summary>
    public const double Colour = 10.0;
}

/// <summary>The fields of a line whose borders are '|'.</summary>
/// <param name="fileName">For messages.</param>
/// <param name="number">Number of the line, from 1.</param>
/// <param name="needed">What such a line is, for messages.</param>
internal readonly struct BarredLine(string line, string fileName, int number, string needed)
{
    private readonly string[] _fields = line.Split('|');

    public int Count => _fields.Length;

    public string Text(int field) => _fields[field].Trim();

    /// <summary>A number; null for a blank field.</summary>
    public double? Number(int field, double least, double greatest)
    {
        string text = Text(field);
        if (text.Length == 0)
        {
            return null;
        }

        return double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            && value >= least && value <= greatest
            ? value
            : throw Wrong(Invariant($"field {field + 1} is '{text}'; a number from {least:R} to {greatest:R} is needed"));
    }

    public BadInputException Wrong(string what) => new(Invariant($"{fileName}, line {number}: {what}. A line of {needed} is needed."));
}

/// <summary>A line of hip_main.dat (ESA SP-1200, volume 1, section 2.1; CDS I/239).</summary>
internal static class HipparcosRow
{
    public const int Fields = 78;

    /// <summary>Julian years after J2000: J1991.25.</summary>
    private const double Epoch = -8.75;

    private const string Needed = "the Hipparcos Catalogue (hip_main.dat, 78 fields)";

    /// <returns>Null for a star without magnitude.</returns>
    public static Star? Read(string line, string fileName, int number)
    {
        BarredLine fields = new(line, fileName, number, Needed);
        if (fields.Count != Fields)
        {
            throw fields.Wrong(Invariant($"it has {fields.Count} fields"));
        }

        // Stars without an astrometric solution have their place in sexagesimal form only.
        (double rightAscension, double declination) =
            (fields.Number(8, 0.0, 360.0), fields.Number(9, -90.0, 90.0)) is (double degrees, double north)
                ? (degrees, north)
                : (15.0 * Sexagesimal(fields, 3), Sexagesimal(fields, 4));
        return fields.Number(5, StarLimits.Brightest, StarLimits.Faintest) is not { } magnitude ? null : Star.FromCatalogue(
            $"HIP {fields.Text(1)}",
            (rightAscension, declination),
            (Motion(fields, 12), Motion(fields, 13)),
            fields.Number(11, -StarLimits.Parallax, StarLimits.Parallax) ?? 0.0,
            Epoch,
            magnitude,
            fields.Number(37, -StarLimits.Colour, StarLimits.Colour));
    }

    private static double Motion(in BarredLine fields, int field) =>
        fields.Number(field, -StarLimits.Motion, StarLimits.Motion) ?? 0.0;

    private static double Sexagesimal(in BarredLine fields, int field)
    {
        string text = fields.Text(field);
        string[] parts = text.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        double[] values = new double[3];
        for (int i = 0; i < 3; i++)
        {
            if (parts.Length != 3 || !double.TryParse(
                parts[i].AsSpan().TrimStart("+-"), NumberStyles.Float, CultureInfo.InvariantCulture, out values[i]))
            {
                throw fields.Wrong(Invariant($"field {field + 1} is '{text}'; hours or degrees, minutes and seconds are needed"));
            }
        }

        double value = values[0] + (values[1] / 60.0) + (values[2] / 3600.0);
        return text.StartsWith('-') ? -value : value;
    }
}

/// <summary>A line of tyc2.dat (E. Hog et al., Astron. Astrophys. 355 (2000) L27; CDS I/259).</summary>
internal static class TychoRow
{
    public const int Fields = 32;

    private const string Needed = "Tycho-2 (tyc2.dat, 32 fields)";

    /// <summary>BT - VT of the Sun, for stars of which one of them is known.</summary>
    private const double ColourOfSun = StarSpectrum.ColourOfSun / ColourFactor;

    private const double ColourFactor = 0.850; // B - V over BT - VT

    private const double MagnitudeFactor = 0.090; // VT - V over BT - VT

    /// <summary>Julian years after J2000 from which the epochs of observed places count.</summary>
    private const double ObservedFrom = -10.0;

    private const double LongestObserved = 5.0; // years

    /// <returns>Null for a star without magnitude.</returns>
    public static Star? Read(string line, string fileName, int number)
    {
        BarredLine fields = new(line, fileName, number, Needed);
        if (fields.Count != Fields)
        {
            throw fields.Wrong(Invariant($"it has {fields.Count} fields"));
        }

        (double? blue, double? visual) = (fields.Number(17, StarLimits.Brightest, StarLimits.Faintest),
            fields.Number(19, StarLimits.Brightest, StarLimits.Faintest));
        if (blue is null && visual is null)
        {
            return null;
        }

        double difference = blue - visual ?? ColourOfSun;
        double magnitude = (visual ?? (blue!.Value - ColourOfSun)) - (MagnitudeFactor * difference);
        double? colour = blue is null || visual is null ? null : ColourFactor * difference;
        IEnumerable<string> parts = fields.Text(0).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(part => part.TrimStart('0'));
        string name = $"TYC {string.Join('-', parts)}";
        return (fields.Number(2, 0.0, 360.0), fields.Number(3, -90.0, 90.0)) is (double mean, double declination)
            ? Star.FromCatalogue(
                name,
                (mean, declination),
                (Motion(fields, 4), Motion(fields, 5)),
                0.0, 0.0, magnitude, colour)
            : Star.FromCatalogue(
                name,
                (fields.Number(24, 0.0, 360.0) ?? throw fields.Wrong("field 25, the right ascension, is empty"),
                    fields.Number(25, -90.0, 90.0) ?? throw fields.Wrong("field 26, the declination, is empty")),
                (0.0, 0.0), 0.0, ObservedFrom + (fields.Number(26, 0.0, LongestObserved) ?? 0.0), magnitude, colour);
    }

    private static double Motion(in BarredLine fields, int field) =>
        fields.Number(field, -StarLimits.Motion, StarLimits.Motion) ?? 0.0;
}

/// <summary>The columns of stars in CSV.</summary>
internal static class StarColumns
{
    private const double J2000 = 2000.0;
    private const double FirstEpoch = 1800.0;
    private const double LastEpoch = 2200.0;

    private const string Wanted = "ra_deg and dec_deg (ICRS, degrees) and v_mag; also hip or id, pm_ra_cosdec_mas_per_year, "
        + "pm_dec_mas_per_year, parallax_mas, b_minus_v and epoch (Julian year; 2000 without it)";

    private static readonly string[] Nothing = ["", "mag"];

    private static readonly string[] Mas = ["", "mas", "mas/yr", "mas/year", "masperyear"];

    public static IEnumerable<Star?> Read(TextReader reader, string fileName)
    {
        ListTable table = ListTable.Open(reader, fileName, null, header => Columns.Of(header).AreThere);
        Columns columns = Columns.Of(table.Header);
        if (!columns.AreThere)
        {
            string names = string.Join(", ", table.Header.Names.Where(name => name.Length > 0));
            throw new BadInputException(
                $"{fileName}: these are not columns of stars: {(names.Length > 0 ? names : "none")}. Name the columns {Wanted}; or give "
                    + "hip_main.dat of Hipparcos or tyc2.dat of Tycho-2.");
        }

        return Rows(table, columns, fileName);
    }

    private static IEnumerable<Star?> Rows(ListTable table, Columns columns, string fileName)
    {
        int number = 0;
        double greatest = 0.0;
        foreach (CsvRow row in table.Rows)
        {
            number++;
            string? given = row.Text(columns.Identity);
            string identity = given is null ? number.ToString(CultureInfo.InvariantCulture)
                : columns.IsHipparcos ? $"HIP {given}" : given;
            double rightAscension = row.Number(columns.RightAscension, 0.0, 360.0);
            greatest = Math.Max(greatest, rightAscension);
            yield return row.Text(columns.Magnitude) is null ? null : Star.FromCatalogue(
                identity,
                (rightAscension, row.Number(columns.Declination, -90.0, 90.0)),
                (Motion(row, columns.MotionEast), Motion(row, columns.MotionNorth)),
                Optional(row, columns.Parallax, StarLimits.Parallax) ?? 0.0,
                (row.Text(columns.Epoch) is null ? J2000 : row.Number(columns.Epoch, FirstEpoch, LastEpoch)) - J2000,
                row.Number(columns.Magnitude, StarLimits.Brightest, StarLimits.Faintest),
                Optional(row, columns.Colour, StarLimits.Colour));
        }

        const int ManyStars = 100; // so many all in the first 24 of 360 degrees are hours
        if (number >= ManyStars && greatest <= 24.0)
        {
            throw new BadInputException(Invariant(
                $"{fileName}: the right ascensions reach to {greatest:R} only, so they seem to be hours; degrees are needed. Multiply them "
                    + $"by 15."));
        }
    }

    private static double Motion(in CsvRow row, int place) => Optional(row, place, StarLimits.Motion) ?? 0.0;

    private static double? Optional(in CsvRow row, int place, double limit) =>
        row.Text(place) is null ? null : row.Number(place, -limit, limit);

    private readonly record struct Columns(
        int Identity, bool IsHipparcos, int RightAscension, int Declination, int MotionEast, int MotionNorth, int Parallax, int Magnitude,
        int Colour, int Epoch)
    {
        public bool AreThere => RightAscension >= 0 && Declination >= 0 && Magnitude >= 0;

        public static Columns Of(ListHeader header)
        {
            int hipparcos = header.PlaceIn(Nothing, string.Empty, "hip", "hipparcos");
            return new Columns(
                hipparcos >= 0 ? hipparcos : header.PlaceIn(Nothing, string.Empty, "id", "name", "identity", "star"),
                hipparcos >= 0,
                header.PlaceOf(string.Empty, "radeg", "ra", "raicrs", "rightascension"),
                header.PlaceOf(string.Empty, "decdeg", "dedeg", "dec", "de", "decicrs", "deicrs", "declination"),
                header.PlaceIn(Mas, string.Empty, "pmracosdecmasperyear", "pmracosdec", "pmra"),
                header.PlaceIn(Mas, string.Empty, "pmdecmasperyear", "pmdec", "pmde"),
                header.PlaceIn(Mas, string.Empty, "parallaxmas", "parallax", "plx"),
                header.PlaceIn(Nothing, string.Empty, "vmag", "v", "vmagnitude", "magnitude", "mag"),
                header.PlaceIn(Nothing, string.Empty, "bminusv", "bv"),
                header.PlaceIn(Nothing, string.Empty, "epoch", "epochyear"));
        }
    }
}
