using Msisf.App.Preview;

namespace Msisf.Cli.Output;

/// <summary>A column of numbers that <c>--dry-run</c> prints.</summary>
/// <param name="Name">Name in CSV and JSON, with the unit.</param>
/// <param name="Heading">First line of the heading of the table.</param>
/// <param name="Unit">Second line of the heading of the table.</param>
/// <param name="Decimals">Decimals in the table.</param>
/// <param name="ValueOf">The number of a row; null if it is undefined.</param>
internal sealed record PreviewColumn(string Name, string Heading, string Unit, int Decimals, Func<PreviewRow, double?> ValueOf)
{
    private static IReadOnlyList<PreviewColumn> OfAnyRun { get; } =
    [
        new("camera_latitude_deg", "latitude", "deg", 4, row => Degrees(row.View.SubSpacecraft.Latitude)),
        new("camera_longitude_deg", "longitude", "deg", 4, row => Degrees(row.View.SubSpacecraft.Longitude)),
        new("height_over_terrain_m", "height", "m", 1, row => row.HeightOverGround),
        new("boresight_latitude_deg", "looks at", "lat deg", 4, row => Degrees(row.View.Boresight?.Point.Latitude)),
        new("boresight_longitude_deg", "looks at", "lon deg", 4, row => Degrees(row.View.Boresight?.Point.Longitude)),
        new("off_nadir_deg", "off nadir", "deg", 2, row => Degrees(row.View.OffNadir)),
        new("sun_elevation_deg", "Sun elev.", "deg", 2, row => Degrees(row.View.Boresight?.Sun?.Elevation)),
        new("sun_azimuth_deg", "azimuth", "deg", 2, row => Degrees(row.View.Boresight?.Sun?.Azimuth)),
        new("metres_per_pixel", "pixel", "m", 3, row => row.View.Boresight?.MetresPerPixel),
        new("pixels_per_cell", "cell", "px", 2, row => row.PixelsPerCell),
        new("moon_fraction", "Moon", "of image", 3, row => row.View.Share.Moon),
        new("lit_fraction", "lit", "of Moon", 3, row => row.View.Share.Lit),
    ];

    private static IReadOnlyList<PreviewColumn> OfDetector { get; } =
    [
        new("expected_dn_median", "lit: median", "DN", 0, row => row.Signal?.Median),
        new("expected_dn_99", "99 %", "DN", 0, row => row.Signal?.High),
    ];

    /// <summary>The columns after step and time; two more of a detector, and of several models one more each, the coarsest first.</summary>
    public static IReadOnlyList<PreviewColumn> Of(IReadOnlyList<PreviewRow> rows) =>
    [
        .. OfAnyRun,
        .. rows.Any(row => row.HasSignal) ? OfDetector : [],
        .. Enumerable.Range(0, rows.Select(row => row.Drawn.Count).DefaultIfEmpty().Max()).Select(DrawnCell),
    ];

    private static PreviewColumn DrawnCell(int part)
    {
        string number = part.ToString(CultureInfo.InvariantCulture);
        return new($"drawn_cell_{number}_m", $"model {number}", "cell m", 1, row => row.Drawn[part]?.MetresPerPixel);
    }

    private static double? Degrees(double? angle) => angle / Math.PI * 180.0;
}
