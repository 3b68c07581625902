using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The map projection of LOLA's polar products, as their labels give it: offsets are those of the pole from the first pixel, which is 0
/// (DSMAP_POLAR.CAT).
/// </summary>
public static class PolarLabel
{
    /// <summary>MAP_PROJECTION_TYPE of polar products.</summary>
    internal const string ProjectionType = "POLAR STEREOGRAPHIC";

    /// <summary>m: the smallest MAP_SCALE; the lattice of the vertices is as fine as cells of this width need.</summary>
    public const double MinScale = 0.5;

    /// <summary>m: the largest MAP_SCALE, one sample a degree.</summary>
    public const double MaxScale = 30_400.0;

    private const string North = "MAXIMUM_LATITUDE";
    private const string South = "MINIMUM_LATITUDE";
    private const string Scale = "MAP_SCALE";
    private const string LineOffset = "LINE_PROJECTION_OFFSET";
    private const string SampleOffset = "SAMPLE_PROJECTION_OFFSET";

    /// <summary>Offsets beyond this are of no image.</summary>
    private const double OffsetLimit = 1 << 24;

    /// <summary>Relative: how far MAP_RESOLUTION, which is rounded in labels, may be from MAP_SCALE.</summary>
    private const double ResolutionRounding = 1e-3;

    /// <summary>Degrees: by how much labels round latitudes; LDEM_80S_20M, whose sides are at 79.98 degrees, says 80.</summary>
    private const double LatitudeRounding = 0.1;

    /// <summary>Reads the projection.</summary>
    /// <exception cref="BadInputException">It is incomplete, or not one of LOLA's polar products.</exception>
    internal static PolarStereographic ProjectionOf(PdsObject map)
    {
        double latitude = map.RequiredNumber("CENTER_LATITUDE", PdsUnit.Degree);
        if (Math.Abs(latitude) != 90.0)
        {
            throw map.WrongValue("CENTER_LATITUDE", "a pole, -90 or 90, is needed");
        }

        double longitude = map.RequiredNumber("CENTER_LONGITUDE", PdsUnit.Degree);
        if (longitude != 0.0)
        {
            throw map.WrongValue("CENTER_LONGITUDE", "0, as LOLA's polar maps have it, is needed");
        }

        // On another sphere the same directions lie farther apart, in proportion to its radius.
        double scale = ScaleOf(map);
        double radius = 1000.0 * map.OptionalNumber("A_AXIS_RADIUS", PdsUnit.Kilometre) ?? MoonConstants.ReferenceRadius;
        CheckResolution(map, scale, radius);
        return new PolarStereographic(
            latitude < 0.0, scale * (MoonConstants.ReferenceRadius / radius), OffsetOf(map, LineOffset), OffsetOf(map, SampleOffset));
    }

    /// <summary>Checks that the image has the size that the label says twice, and lies around the pole.</summary>
    /// <exception cref="BadInputException">It does not.</exception>
    internal static void CheckCover(LdemLabel label, PdsObject image, PdsObject map)
    {
        if (label.Lines < 2 || label.LineSamples < 2)
        {
            throw image.WrongValue("LINES", "an image of at least 2 x 2 samples is needed");
        }

        LdemLabelChecks.CheckPixels(label, map);
        PolarStereographic projection = label.Polar!;
        if (!projection.Holds(label.Lines, label.LineSamples))
        {
            throw map.WrongValue(Scale, Invariant(
                $"with offsets of {projection.LineOffset:R} and {projection.SampleOffset:R} px and {label.Lines} lines of "
                    + $"{label.LineSamples} samples the map reaches farther than "
                    + $"{MoonConstants.ReferenceRadius / 1000.0:R} km from the pole"));
        }

        CheckLatitudes(label, map);
    }

    /// <summary>
    /// Checks that the latitudes are those of the map: on the side of its pole, and as far from it as its corners and sides. LOLA's labels
    /// have the latitude in the middle of the sides; others that of the corners.
    /// </summary>
    private static void CheckLatitudes(LdemLabel label, PdsObject map)
    {
        (string near, string far) = label.Polar!.IsSouth ? (South, North) : (North, South);
        double sign = label.Polar.IsSouth ? -1.0 : 1.0;
        if (map.OptionalNumber(near, PdsUnit.Degree) is { } poleward && !(sign * poleward is > 0.0 and <= 90.0))
        {
            throw map.WrongValue(near, $"CENTER_LATITUDE = {map.Required("CENTER_LATITUDE")} needs a latitude of that hemisphere");
        }

        if (map.OptionalNumber(far, PdsUnit.Degree) is not { } outermost)
        {
            return;
        }

        (double side, double corner) = LatitudesOf(label);
        if (!(sign * outermost <= side + LatitudeRounding && sign * outermost >= corner - LatitudeRounding))
        {
            throw map.WrongValue(far, Invariant(
                $"CENTER_LATITUDE = {map.Required("CENTER_LATITUDE")}, {Scale} and the offsets put the map's sides at {sign * side:F2} and "
                    + $"its corners at {sign * corner:F2} degrees"));
        }
    }

    /// <summary>
    /// Degrees from the equator: of the nearest side, or without the pole of the place nearest to it, and of the farthest corner.
    /// </summary>
    private static (double Side, double Corner) LatitudesOf(LdemLabel label)
    {
        PolarStereographic polar = label.Polar!;
        double[] lines = [-0.5 - polar.LineOffset, label.Lines - 0.5 - polar.LineOffset];
        double[] samples = [-0.5 - polar.SampleOffset, label.LineSamples - 0.5 - polar.SampleOffset];
        bool holdsPole = lines[0] < 0.0 && lines[1] > 0.0 && samples[0] < 0.0 && samples[1] > 0.0;
        double nearest = holdsPole
            ? new[] { -lines[0], lines[1], -samples[0], samples[1] }.Min()
            : double.Hypot(NearestTo0(lines), NearestTo0(samples));
        double farthest = double.Hypot(lines.Max(Math.Abs), samples.Max(Math.Abs));
        return (LatitudeAt(nearest), LatitudeAt(farthest));

        double LatitudeAt(double pixels) => 90.0 - double.RadiansToDegrees(
            2.0 * Math.Atan2(pixels * polar.MetresPerPixel, 2.0 * MoonConstants.ReferenceRadius));

        static double NearestTo0(double[] range) => range[0] <= 0.0 && range[1] >= 0.0 ? 0.0 : range.Min(Math.Abs);
    }

    private static double ScaleOf(PdsObject map)
    {
        bool isInKilometres = map.Required(Scale).Unit is { } unit && PdsUnit.Of(unit) == PdsUnit.KilometresPerPixel;
        double scale = isInKilometres
            ? 1000.0 * map.RequiredNumber(Scale, PdsUnit.KilometresPerPixel)
            : map.RequiredNumber(Scale, PdsUnit.MetresPerPixel);
        return scale is >= MinScale and <= MaxScale ? scale : throw map.WrongValue(Scale, Invariant(
            $"{MinScale:R} to {MaxScale:R} m a pixel are needed"));
    }

    private static double OffsetOf(PdsObject map, string keyword)
    {
        double offset = map.RequiredNumber(keyword, PdsUnit.Pixel);
        return Math.Abs(offset) <= OffsetLimit
            ? offset
            : throw map.WrongValue(keyword, "the pole's place in the image, px, is needed");
    }

    private static void CheckResolution(PdsObject map, double scale, double radius)
    {
        const string Keyword = "MAP_RESOLUTION";
        double expected = radius * Math.PI / 180.0 / scale;
        if (map.OptionalNumber(Keyword, PdsUnit.PixelsPerDegree) is { } given
            && !(Math.Abs(given - expected) <= ResolutionRounding * expected))
        {
            throw map.WrongValue(Keyword, Invariant(
                $"{Scale} = {map.Required(Scale)} needs {expected:F3}"));
        }
    }
}
