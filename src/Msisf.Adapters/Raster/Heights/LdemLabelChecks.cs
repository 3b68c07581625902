using System.Globalization;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
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
            CheckText(map, "MAP_PROJECTION_TYPE", "SIMPLE CYLINDRICAL", isMoon
                ? $"SIMPLE CYLINDRICAL or {PolarLabel.ProjectionType} is needed"
                : "SIMPLE CYLINDRICAL is needed for other bodies than the Moon");
        }

        CheckText(map, "POSITIVE_LONGITUDE_DIRECTION", "EAST", "EAST is needed");
        CheckNumber(map, "MAP_PROJECTION_ROTATION", 0.0, []);
        if (isMoon && !map.RequiredText("COORDINATE_SYSTEM_NAME").Contains("MEAN EARTH", StringComparison.Ordinal))
        {
            throw map.WrongValue(
                "COORDINATE_SYSTEM_NAME", map.Required("COORDINATE_SYSTEM_NAME"), "the MEAN EARTH/POLAR AXIS frame is needed");
        }
    }

    /// <summary>The body of the product; the Moon if the label names none.</summary>
    /// <exception cref="BadInputException">It is none that can be drawn.</exception>
    public static CelestialBody BodyOf(PdsObject root) => root.Find("TARGET_NAME") is not { } target
        ? CelestialBody.Moon
        : CelestialBody.Find(target.ToString()) ?? throw root.WrongValue(
            "TARGET_NAME",
            target,
            $"an elevation model of {string.Join(", ", CelestialBody.All.Select(body => body.CapitalName))} is needed");

    /// <summary>Whether the map is a polar stereographic one.</summary>
    public static bool IsPolar(PdsObject map) => map.RequiredText("MAP_PROJECTION_TYPE") == PolarLabel.ProjectionType;

    /// <summary>Checks that lines and samples fill the borders at the resolution, and that the projection's offsets agree.</summary>
    /// <exception cref="BadInputException">They don't.</exception>
    public static void CheckCover(LdemLabel label, PdsObject image, PdsObject map)
    {
        CheckCount(image, "LINES", label.Lines, label.NorthDegrees - label.SouthDegrees, label.PixelsPerDegree);
        CheckCount(image, "LINE_SAMPLES", label.LineSamples, label.EastDegrees - label.WestDegrees, label.PixelsPerDegree);
        CheckNumber(map, "LINE_FIRST_PIXEL", 1, PdsUnits.Pixels);
        CheckNumber(map, "LINE_LAST_PIXEL", label.Lines, PdsUnits.Pixels);
        CheckNumber(map, "SAMPLE_FIRST_PIXEL", 1, PdsUnits.Pixels);
        CheckNumber(map, "SAMPLE_LAST_PIXEL", label.LineSamples, PdsUnits.Pixels);
        double centreLatitude = map.RequiredNumber("CENTER_LATITUDE", PdsUnits.Degrees);
        double centreLongitude = map.RequiredNumber("CENTER_LONGITUDE", PdsUnits.Degrees);
        double lineOffset = ((label.NorthDegrees - centreLatitude) * label.PixelsPerDegree) - 0.5;
        double sampleOffset = ((centreLongitude - label.WestDegrees) * label.PixelsPerDegree) - 0.5;
        CheckNumber(map, "LINE_PROJECTION_OFFSET", lineOffset, PdsUnits.Pixels);
        CheckNumber(map, "SAMPLE_PROJECTION_OFFSET", sampleOffset, PdsUnits.Pixels);
    }

    /// <summary>
    /// Checks that every allowed sample value gives a radius, that samples and map have the same sphere, and that no other bytes lie
    /// between the samples.
    /// </summary>
    /// <exception cref="BadInputException">It is not so.</exception>
    public static void CheckSamples(LdemLabel label, PdsObject image, PdsObject map)
    {
        CheckNumber(image, "BANDS", 1, []);
        CheckNumber(image, "LINE_PREFIX_BYTES", 0, []);
        CheckNumber(image, "LINE_SUFFIX_BYTES", 0, []);
        CheckText(image, "ENCODING_TYPE", "N/A", "an image without compression is needed");
        if (label.ScalingFactor <= 0.0)
        {
            throw image.WrongValue("SCALING_FACTOR", image.Required("SCALING_FACTOR"), "a number above 0 is needed");
        }

        bool fitsType = !label.HasIntegers || (label.Minimum >= short.MinValue && label.Maximum <= short.MaxValue);
        if (!fitsType || label.Minimum > label.Maximum)
        {
            throw image.WrongValue(
                "MINIMUM",
                image.Required("MINIMUM"),
                $"with MAXIMUM = {image.Required("MAXIMUM")} no {label.SampleBytes * 8}-bit sample can be right");
        }

        double lowest = label.Offset + (label.ScalingFactor * label.Minimum);
        double highest = label.Offset + (label.ScalingFactor * label.Maximum);
        if (!(lowest > 0.0 && highest < LatticePoint.RadiusLimit))
        {
            throw image.WrongValue(
                "OFFSET", image.Required("OFFSET"), "with MINIMUM, MAXIMUM and SCALING_FACTOR this gives no radius of the Moon");
        }

        foreach (string axis in new[] { "A_AXIS_RADIUS", "B_AXIS_RADIUS", "C_AXIS_RADIUS" })
        {
            if (map.OptionalNumber(axis, PdsUnits.Kilometres) is { } radius
                && Math.Abs((1000.0 * radius) - label.Offset) > Tolerances.LabelRadius)
            {
                throw map.WrongValue(axis, map.Required(axis), Invariant($"the heights are over a sphere of {label.Offset:R} m (OFFSET)"));
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
            throw file.WrongValue("FILE_RECORDS", file.Required("FILE_RECORDS"), string.Create(
                CultureInfo.InvariantCulture,
                $"with RECORD_BYTES = {file.Required("RECORD_BYTES")} these are {found} bytes, "
                    + $"but the image needs {needed} (LINES x LINE_SAMPLES x SAMPLE_BITS / 8)"));
        }
    }

    private static void CheckCount(PdsObject image, string keyword, int count, double degrees, int pixelsPerDegree)
    {
        double needed = degrees * pixelsPerDegree;
        if (count != needed)
        {
            throw image.WrongValue(keyword, image.Required(keyword), Invariant(
                $"the map's borders and MAP_RESOLUTION ({degrees:R} degrees, {pixelsPerDegree} px/deg) need {needed:R}"));
        }
    }

    /// <summary>Checks that a text, if the label has it, is the expected one.</summary>
    /// <exception cref="BadInputException">It is another one.</exception>
    public static void CheckText(PdsObject holder, string keyword, string expected, string need)
    {
        if (holder.Find(keyword) is { } value && value.ToString() != expected)
        {
            throw holder.WrongValue(keyword, value, need);
        }
    }

    /// <summary>Checks that a number, if the label has it, is the expected one.</summary>
    /// <exception cref="BadInputException">It is another one.</exception>
    public static void CheckNumber(PdsObject holder, string keyword, double expected, string[] units)
    {
        if (holder.OptionalNumber(keyword, units) is { } number && number != expected)
        {
            throw holder.WrongValue(keyword, holder.Required(keyword), Invariant($"the rest of the label needs {expected:R}"));
        }
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
