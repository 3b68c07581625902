using System.Globalization;
using Msisf.Adapters.Terrain;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// Writes the PDS3 label of a synthetic product: keywords in the order of the LOLA archive's labels, with values that say that the model is
/// synthetic.
/// </summary>
internal static class SyntheticLdemLabel
{
    /// <summary>Writes the label.</summary>
    /// <param name="writer">Receives the text, lines ended by LF.</param>
    /// <param name="product">What is described.</param>
    /// <param name="options">How it was made.</param>
    /// <param name="minimum">Minimum sample in the image.</param>
    /// <param name="maximum">Maximum sample in the image.</param>
    public static void Write(TextWriter writer, SyntheticLdemProduct product, SyntheticLdemOptions options, double minimum, double maximum)
    {
        double metresPerPixel = MoonConstants.ReferenceRadius * Math.PI / (180.0 * product.PixelsPerDegree);
        string scale = metresPerPixel.ToString("0.00", CultureInfo.InvariantCulture);
        string source = options.Base is null
            ? "nothing (a made-up global shape)"
            : $"{options.Base.ProductId} ({options.Base.PixelsPerDegree.ToString(CultureInfo.InvariantCulture)} pix/deg), "
                + $"whose pixel means it keeps";
        MoonRegion region = product.Cover;
        SyntheticSampleFormat format = product.Format;

        // As in the archive: offsets count from the product's own first pixel to the projection's centre at latitude 0, longitude 180.
        double lineOffset = (region.NorthDegrees * product.PixelsPerDegree) - 0.5;
        double sampleOffset = ((180 - region.WestDegrees) * product.PixelsPerDegree) - 0.5;
        writer.Write(string.Create(CultureInfo.InvariantCulture, $$"""
            PDS_VERSION_ID            = "PDS3"

            /*** GENERAL DATA DESCRIPTION PARAMETERS ***/
            PRODUCT_VERSION_ID        = "V1.0"
            DATA_SET_ID               = "MSISF-L-{{LdemLabel.SyntheticMark}}-LDEM-V1.0"
            PRODUCT_ID                = "{{product.ProductId}}"
            INSTRUMENT_HOST_NAME      = "N/A"
            INSTRUMENT_NAME           = "N/A"
            INSTRUMENT_ID             = "N/A"
            MISSION_PHASE_NAME        = "N/A"
            TARGET_NAME               = MOON
            START_TIME                = "N/A"
            STOP_TIME                 = "N/A"
            PRODUCT_CREATION_TIME     = "N/A"
            PRODUCER_ID               = "MSISF"
            PRODUCER_FULL_NAME        = "MSISF, msis ldem synthesize"
            PRODUCER_INSTITUTION_NAME = "N/A"
            DESCRIPTION               = "THIS IS SYNTHETIC DATA. NO PART OF THE DETAIL
               WAS MEASURED; IT IS NOT A PRODUCT OF THE LOLA TEAM, NASA OR THE PDS.
               A shape map (radius) of a Moon at a resolution of {{scale}} m/pix by
               {{scale}} m/pix, computed from the seed
               {{options.Seed}}, continuing
               {{source}},
               downwards with random craters and roughness that follow the Moon's
               statistics{{DetailIn(product)}}. The map is in the form of a binary table with one row for
               each 1/{{product.PixelsPerDegree}} degree of latitude, pixel registered. Map values are
               relative to a radius of 1737.4 km.
            "

            OBJECT                    = UNCOMPRESSED_FILE
            FILE_NAME                 = "{{product.ProductId}}.IMG"
            RECORD_TYPE               = FIXED_LENGTH
            FILE_RECORDS              = {{product.Lines}}
            RECORD_BYTES              = {{format.SampleBytes * product.LineSamples}}
            ^IMAGE                    = "{{product.ProductId}}.IMG"


              OBJECT                  = IMAGE
                NAME                  = HEIGHT
                DESCRIPTION           = "Each sample represents height relative to a
                  reference radius (OFFSET). The heights are synthetic."
                LINES                 = {{product.Lines}}
                LINE_SAMPLES          = {{product.LineSamples}}
                MAXIMUM               = {{format.TextOf(maximum)}}
                MINIMUM               = {{format.TextOf(minimum)}}
                SAMPLE_TYPE           = {{format.TypeKeyword}}
                SAMPLE_BITS           = {{8 * format.SampleBytes}}
                UNIT                  = {{format.Unit}}
                SCALING_FACTOR        = {{format.ScalingFactor}}
                OFFSET                = {{format.Offset}}

            {{Comment("NOTE:")}}
            {{Comment($"Conversion from Digital Number to HEIGHT, i.e. elevation in {format.UnitWord}, is:")}}
            {{Comment("HEIGHT = (DN * SCALING_FACTOR).")}}
            {{Comment($"The conversion from Digital Number to PLANETARY_RADIUS in {format.UnitWord} is:")}}
            {{Comment("PLANETARY_RADIUS = (DN * SCALING_FACTOR) + OFFSET")}}
            {{Comment("where OFFSET is the radius of a reference sphere.")}}

              END_OBJECT              = IMAGE
            END_OBJECT                = UNCOMPRESSED_FILE
            OBJECT                    = IMAGE_MAP_PROJECTION
             ^DATA_SET_MAP_PROJECTION     = "DSMAP.CAT"
             MAP_PROJECTION_TYPE          = "SIMPLE CYLINDRICAL"
             MAP_RESOLUTION               = {{product.PixelsPerDegree}} <pix/deg>
             A_AXIS_RADIUS                = 1737.4 <km>
             B_AXIS_RADIUS                = 1737.4 <km>
             C_AXIS_RADIUS                = 1737.4 <km>
             FIRST_STANDARD_PARALLEL      = 'N/A'
             SECOND_STANDARD_PARALLEL     = 'N/A'
             POSITIVE_LONGITUDE_DIRECTION = "EAST"
             CENTER_LATITUDE              = 0 <deg>
             CENTER_LONGITUDE             = 180 <deg>
             REFERENCE_LATITUDE           = 'N/A'
             REFERENCE_LONGITUDE          = 'N/A'
             LINE_FIRST_PIXEL             = 1
             LINE_LAST_PIXEL              = {{product.Lines}}
             SAMPLE_FIRST_PIXEL           = 1
             SAMPLE_LAST_PIXEL            = {{product.LineSamples}}
             MAP_PROJECTION_ROTATION      = 0.0
             MAP_SCALE                    = {{scale}} <m/pix>
             MAXIMUM_LATITUDE             = {{region.NorthDegrees}} <deg>
             MINIMUM_LATITUDE             = {{region.SouthDegrees}} <deg>
             WESTERNMOST_LONGITUDE        = {{region.WestDegrees}} <deg>
             EASTERNMOST_LONGITUDE        = {{region.EastDegrees}} <deg>
             LINE_PROJECTION_OFFSET       = {{lineOffset:0.0}} <pix>
             SAMPLE_PROJECTION_OFFSET     = {{sampleOffset:0.0}} <pix>
             COORDINATE_SYSTEM_TYPE       = "BODY-FIXED ROTATING"
             COORDINATE_SYSTEM_NAME       = "MEAN EARTH/POLAR AXIS OF DE421"
            END_OBJECT                    = IMAGE_MAP_PROJECTION

            END

            """));
    }

    private static string Comment(string text)
    {
        const int Width = 72;
        return $"/* {text.PadRight(Width)}*/";
    }

    /// <summary>Continues the sentence about the detail, by where it is.</summary>
    private static string DetailIn(SyntheticLdemProduct product)
    {
        if (product.Rest == SyntheticRest.None || product.Region == MoonRegion.WholeMoon)
        {
            return string.Empty;
        }

        MoonRegion region = product.Region;
        return string.Create(
            CultureInfo.InvariantCulture,
            $",\n   in latitudes {region.SouthDegrees} to {region.NorthDegrees} and longitudes {region.WestDegrees} to "
                + $"{region.EastLongitude} only; the rest\n   is {(product.Rest == SyntheticRest.Base ? "interpolated" : "flat")}");
    }
}
