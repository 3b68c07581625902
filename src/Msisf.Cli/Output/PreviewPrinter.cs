using System.Text.Json.Nodes;
using Msisf.App.Preview;
using Msisf.App.Settings;

namespace Msisf.Cli.Output;

/// <summary>Prints what the images of a run would show, a line for each.</summary>
internal static class PreviewPrinter
{
    private const string Step = "step";
    private const string Camera = "camera";
    private const string Time = "utc";

    /// <summary>What the table has where a number is undefined.</summary>
    private const string Undefined = "-";

    public static void Print(IReadOnlyList<PreviewRow> rows, PreviewFormat format, TextWriter results)
    {
        IReadOnlyList<PreviewColumn> columns = PreviewColumn.Of(rows);
        TextTable.Print(results, format switch
        {
            PreviewFormat.Csv => Csv(rows, columns),
            PreviewFormat.Json => TextTable.Json(rows.Select(row => JsonOf(row, columns))),
            _ => TextTable.Columns(Cells(rows, columns), isRight: true),
        });
    }

    private static IEnumerable<string> Csv(IReadOnlyList<PreviewRow> rows, IReadOnlyList<PreviewColumn> columns) => rows
        .Select(row => Joined([.. Named(row), row.Time.ToIsoUtc()], columns, column => Text(column.ValueOf(row), "R")))
        .Prepend(Joined([Step, .. rows[0].Camera is null ? (string[])[] : [Camera], Time], columns, column => column.Name));

    private static string Joined(string[] first, IReadOnlyList<PreviewColumn> columns, Func<PreviewColumn, string> textOf) =>
        string.Join(',', (string[])[.. first, .. columns.Select(textOf)]);

    /// <summary>The step, and the camera of a rig.</summary>
    private static string[] Named(PreviewRow row) => row.Camera is { } camera ? [Text(row.Step, "F0"), camera] : [Text(row.Step, "F0")];

    private static JsonObject JsonOf(PreviewRow row, IReadOnlyList<PreviewColumn> columns) => new(
    [
        new(Step, row.Step),
        .. row.Camera is { } camera ? (KeyValuePair<string, JsonNode?>[])[new(Camera, camera)] : [],
        new(Time, row.Time.ToIsoUtc()),
        .. columns.Select(column => new KeyValuePair<string, JsonNode?>(column.Name, column.ValueOf(row))),
    ]);

    private static string[][] Cells(IReadOnlyList<PreviewRow> rows, IReadOnlyList<PreviewColumn> columns)
    {
        bool isRig = rows[0].Camera is not null;
        return
        [
            [Step, .. isRig ? (string[])[Camera] : [], "time", .. columns.Select(column => column.Heading)],
            [string.Empty, .. isRig ? (string[])[string.Empty] : [], string.Empty, .. columns.Select(column => column.Subheading)],
            [string.Empty, .. isRig ? (string[])[string.Empty] : [], "UTC", .. columns.Select(column => column.Unit)],
            .. rows.Select(row => (string[])
            [
                .. Named(row), row.Time.ToIsoUtc(), .. columns.Select(column => TableCell(column, row)),
            ]),
        ];
    }

    private static string TableCell(PreviewColumn column, PreviewRow row) =>
        column.ValueOf(row) is { } number ? Text(number, Invariant($"F{column.Decimals}")) : Undefined;

    /// <summary>A number, without the sign of a 0; empty if it is undefined.</summary>
    private static string Text(double? number, string format)
    {
        string text = number?.ToString(format, CultureInfo.InvariantCulture) ?? string.Empty;
        return text.StartsWith('-') && text.AsSpan(1).IndexOfAnyExcept('0', '.') < 0 ? text[1..] : text;
    }
}

/// <summary>A column of numbers that <c>--dry-run</c> prints.</summary>
/// <param name="Name">Name in CSV and JSON, with the unit.</param>
/// <param name="Heading">First line of the heading of the table.</param>
/// <param name="Subheading">Second line.</param>
/// <param name="Unit">Third line.</param>
/// <param name="Decimals">Decimals in the table.</param>
/// <param name="Read">The number of a row; null if it is undefined.</param>
internal sealed record PreviewColumn(
    string Name, string Heading, string Subheading, string Unit, int Decimals, Func<PreviewRow, double?> Read)
{
    private static IReadOnlyList<PreviewColumn> OfAnyRun { get; } =
    [
        new("camera_latitude_deg", "camera", "latitude", "deg", 4, row => Degrees(row.View.SubSpacecraft.Latitude)),
        new("camera_longitude_deg", "camera", "longitude", "deg", 4, row => Degrees(row.View.SubSpacecraft.Longitude)),
        new("height_over_terrain_m", "height over", "terrain", "m", 1, row => row.HeightOverGround),
        new("boresight_latitude_deg", "looks at", "latitude", "deg", 4, row => Degrees(row.View.Boresight?.Point.Latitude)),
        new("boresight_longitude_deg", "looks at", "longitude", "deg", 4, row => Degrees(row.View.Boresight?.Point.Longitude)),
        new("off_nadir_deg", "angle off", "nadir", "deg", 2, row => Degrees(row.View.OffNadir)),
        new("sun_elevation_deg", "Sun's", "elevation", "deg", 2, row => Degrees(row.View.Boresight?.Sun?.Elevation)),
        new("sun_azimuth_deg", "Sun's", "azimuth", "deg", 2, row => Degrees(row.View.Boresight?.Sun?.Azimuth)),
        new("metres_per_pixel", "width of", "a pixel", "m", 3, row => row.View.Boresight?.MetresPerPixel),
        new("pixels_per_cell", "width of", "a cell", "px", 2, row => row.PixelsPerCell),
        new("moon_fraction", "Moon's part", "of image", "0 to 1", 3, row => row.View.Share.Moon),
        new("lit_fraction", "lit part", "of Moon", "0 to 1", 3, row => row.View.Share.Lit),
    ];

    private static IReadOnlyList<PreviewColumn> OfDetector { get; } =
    [
        new("expected_dn_median", "lit pixels'", "median", "DN", 0, row => row.Signal?.Median),
        new("expected_dn_99", "lit pixels'", "99 %", "DN", 0, row => row.Signal?.High),
    ];

    /// <summary>The columns after step and time; two more of a detector, and of several models one more each, the coarsest first.</summary>
    public static IReadOnlyList<PreviewColumn> Of(IReadOnlyList<PreviewRow> rows) =>
    [
        .. OfAnyRun,
        .. rows.Any(row => row.HasSignal) ? OfDetector : [],
        .. Enumerable.Range(0, rows.Select(row => row.Drawn.Count).DefaultIfEmpty().Max()).Select(DrawnCell),
    ];

    /// <summary>The number of a row, never -0; null if it is undefined.</summary>
    public double? ValueOf(PreviewRow row) => Read(row) + 0.0;

    private static PreviewColumn DrawnCell(int part)
    {
        string number = part.ToString(CultureInfo.InvariantCulture);
        return new($"drawn_cell_{number}_m", $"model {number}", "cell drawn", "m", 1, row => row.Drawn[part]?.MetresPerPixel);
    }

    private static double? Degrees(double? angle) => angle / Math.PI * 180.0;
}
