using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Ephemeris;
using Msisf.Core.Surface;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Checks that a label describes an elevation model and does not contradict itself.</summary>
internal static class LdemLabelChecks
{
    /// <summary>
    /// Checks that the product is of a body that can be drawn, in a projection that can be read; of the Moon also in the ME/PA frame.
    /// </summary>
    /// <exception cref="BadInputException">It is another product.</exception>
    public static void CheckKind(PdsObject root, PdsObject map)
    {
        bool isMoon = BodyOf(root).IsMoon;
        if (!IsPolar(map) || !isMoon)
        {
            map.CheckText("MAP_PROJECTION_TYPE", "SIMPLE CYLINDRICAL", isMoon
                ? $"SIMPLE CYLINDRICAL or {PolarLabel.ProjectionType} is needed"
                : "SIMPLE CYLINDRICAL is needed for other bodies than the Moon");
        }

        PdsLongitudes.RequireEast(map);
        map.CheckNumber("MAP_PROJECTION_ROTATION", 0.0);
        if (isMoon && !PdsValue.WordOf(map.RequiredText("COORDINATE_SYSTEM_NAME")).Contains("MEAN_EARTH", StringComparison.Ordinal))
        {
            throw map.WrongValue("COORDINATE_SYSTEM_NAME", "the MEAN EARTH/POLAR AXIS frame is needed");
        }
    }

    /// <summary>The body of the product; the Moon if the label names none.</summary>
    /// <exception cref="BadInputException">It is none that can be drawn.</exception>
    public static CelestialBody BodyOf(PdsObject root) => root.Find("TARGET_NAME") is not { } target
        ? CelestialBody.Moon
        : CelestialBody.Find(target.Word) ?? throw root.WrongValue(
            "TARGET_NAME", $"an elevation model of {string.Join(", ", CelestialBody.All.Select(body => body.CapitalName))} is needed");

    /// <summary>Whether the map is a polar stereographic one.</summary>
    public static bool IsPolar(PdsObject map) =>
        PdsValue.WordOf(map.RequiredText("MAP_PROJECTION_TYPE")) == PdsValue.WordOf(PolarLabel.ProjectionType);

    /// <summary>Checks that lines and samples fill the borders at the resolution, and that the projection's offsets agree.</summary>
    /// <exception cref="BadInputException">They don't.</exception>
    public static void CheckCover(LdemLabel label, PdsObject image, PdsObject map)
    {
        CheckCount(image, "LINES", label.Lines, label.NorthDegrees - label.SouthDegrees, label.PixelsPerDegree);
        CheckCount(image, "LINE_SAMPLES", label.LineSamples, label.EastDegrees - label.WestDegrees, label.PixelsPerDegree);
        CheckPixels(label, map);
        double centreLatitude = map.RequiredNumber("CENTER_LATITUDE", PdsUnit.Degree);
        double centreLongitude = map.RequiredNumber("CENTER_LONGITUDE", PdsUnit.Degree);
        map.CheckNumber(
            "LINE_PROJECTION_OFFSET", ((label.NorthDegrees - centreLatitude) * label.PixelsPerDegree) - 0.5, PdsUnit.Pixel);
        map.CheckNumber(
            "SAMPLE_PROJECTION_OFFSET", ((centreLongitude - label.WestDegrees) * label.PixelsPerDegree) - 0.5, PdsUnit.Pixel);
    }

    /// <summary>Checks that the map has the lines and samples of the image.</summary>
    /// <exception cref="BadInputException">It has others.</exception>
    public static void CheckPixels(LdemLabel label, PdsObject map)
    {
        map.CheckNumber("LINE_FIRST_PIXEL", 1, PdsUnit.Pixel);
        map.CheckNumber("LINE_LAST_PIXEL", label.Lines, PdsUnit.Pixel);
        map.CheckNumber("SAMPLE_FIRST_PIXEL", 1, PdsUnit.Pixel);
        map.CheckNumber("SAMPLE_LAST_PIXEL", label.LineSamples, PdsUnit.Pixel);
    }

    /// <summary>Checks that some sample values are allowed, and that no other bytes lie between the samples.</summary>
    /// <exception cref="BadInputException">It is not so.</exception>
    public static void CheckSamples(LdemLabel label, PdsObject image)
    {
        image.CheckNumber("BANDS", 1);
        image.CheckNumber("LINE_PREFIX_BYTES", 0);
        image.CheckNumber("LINE_SUFFIX_BYTES", 0);
        image.CheckText("ENCODING_TYPE", "N/A", "an image without compression is needed");
        if (label.ScalingFactor <= 0.0)
        {
            throw image.WrongValue("SCALING_FACTOR", "a number above 0 is needed");
        }

        bool fitsType = !label.HasIntegers || (IsOfType(label.Minimum) && IsOfType(label.Maximum));
        if (!fitsType || label.Minimum > label.Maximum)
        {
            throw image.WrongValue(
                "MINIMUM", $"with MAXIMUM = {image.Required("MAXIMUM")} no {label.SampleBytes * 8}-bit sample can be right");
        }
    }

    /// <summary>Checks that every allowed sample value gives a radius, and that samples and map have the same sphere.</summary>
    /// <param name="label">A label within plausible heights.</param>
    /// <exception cref="BadInputException">It is not so.</exception>
    public static void CheckRadii(LdemLabel label, PdsObject image, PdsObject map)
    {
        double lowest = label.Offset + (label.ScalingFactor * label.Minimum);
        double highest = label.Offset + (label.ScalingFactor * label.Maximum);
        if (!(lowest > 0.0 && lowest <= highest && highest < LatticePoint.RadiusLimit))
        {
            throw image.WrongValue("OFFSET", $"with MINIMUM, MAXIMUM and SCALING_FACTOR this gives no radius of {label.Body.NameInText}");
        }

        foreach (string axis in new[] { "A_AXIS_RADIUS", "B_AXIS_RADIUS", "C_AXIS_RADIUS" })
        {
            if (map.OptionalNumber(axis, PdsUnit.Kilometre) is { } radius
                && Math.Abs((1000.0 * radius) - label.Offset) > Tolerances.LabelRadius)
            {
                throw map.WrongValue(axis, Invariant($"the heights are over a sphere of {label.Offset:R} m (OFFSET)"));
            }
        }
    }

    /// <summary>Checks that the file's records hold the image, exactly if there is nothing else in the file.</summary>
    /// <exception cref="BadInputException">They hold more or less.</exception>
    public static void CheckRecords(LdemLabel label, PdsObject file, bool isDetached)
    {
        long needed = label.ImageOffset + label.ImageBytes;
        if (label.FileBytes is { } found && (found < needed || (isDetached && label.ImageOffset == 0 && found != needed)))
        {
            throw file.WrongValue(
                "FILE_RECORDS",
                Invariant($"with RECORD_BYTES = {file.Required("RECORD_BYTES")} these are {found} bytes, ")
                    + Invariant($"but the image needs {needed} (LINES x LINE_SAMPLES x SAMPLE_BITS / 8)"));
        }
    }

    /// <summary>Whether a limit is a 16-bit integer, or none.</summary>
    private static bool IsOfType(double limit) => double.IsInfinity(limit) || limit is >= short.MinValue and <= short.MaxValue;

    private static void CheckCount(PdsObject image, string keyword, int count, double degrees, int pixelsPerDegree)
    {
        double needed = degrees * pixelsPerDegree;
        if (count != needed)
        {
            throw image.WrongValue(keyword, Invariant(
                $"the map's borders and MAP_RESOLUTION ({degrees:R} degrees, {pixelsPerDegree} px/deg) need {needed:R}"));
        }
    }
}
