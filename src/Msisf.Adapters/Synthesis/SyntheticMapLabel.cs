using System.Globalization;
using Msisf.Adapters.Terrain;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// Writes the PDS3 label of a synthetic polar map: keywords in the order of the LOLA archive's labels of polar products.
/// </summary>
internal static class SyntheticMapLabel
{
    /// <summary>Writes the label.</summary>
    /// <param name="writer">Receives the text, lines ended by LF.</param>
    /// <param name="options">What is described, and how it was made.</param>
    /// <param name="minimum">Minimum sample in the image.</param>
    /// <param name="maximum">Maximum sample in the image.</param>
    public static void Write(TextWriter writer, SyntheticMapOptions options, double minimum, double maximum)
    {
        string source = options.Base is null ? "nothing (a made-up global shape)" : options.Base.ProductId;
        SyntheticSampleFormat format = options.Format;
        double pole = options.IsSouth ? -90.0 : 90.0;
        double border = options.IsSouth ? -options.LatitudeDegrees : options.LatitudeDegrees;
        double resolution = MoonConstants.ReferenceRadius * Math.PI / 180.0 / options.MetresPerPixel;
        writer.Write(string.Create(CultureInfo.InvariantCulture, $$"""
            PDS_VERSION_ID            = "PDS3"

            /*** GENERAL DATA DESCRIPTION PARAMETERS ***/
            PRODUCT_VERSION_ID        = "V1.0"
            DATA_SET_ID               = "MSISF-L-{{LdemLabel.SyntheticMark}}-LDEM-V1.0"
            PRODUCT_ID                = "{{options.ProductId}}"
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
               A shape map (radius) of a Moon at a scale of {{options.MetresPerPixel:R}} m/pix,
               computed from the seed
               {{options.Seed}}, continuing
               {{source}},
               downwards with random craters and roughness that follow the Moon's
               statistics, in polar stereographic projection, true to scale at the
               pole. Map values are relative to a radius of 1737.4 km.
            "

            OBJECT                    = UNCOMPRESSED_FILE
            FILE_NAME                 = "{{options.ProductId}}.IMG"
            RECORD_TYPE               = FIXED_LENGTH
            FILE_RECORDS              = {{options.Side}}
            RECORD_BYTES              = {{format.SampleBytes * options.Side}}
            ^IMAGE                    = "{{options.ProductId}}.IMG"


              OBJECT                  = IMAGE
                NAME                  = HEIGHT
                DESCRIPTION           = "Each sample represents height relative to a
                  reference radius (OFFSET). The heights are synthetic."
                LINES                 = {{options.Side}}
                LINE_SAMPLES          = {{options.Side}}
                MAXIMUM               = {{format.TextOf(maximum)}}
                MINIMUM               = {{format.TextOf(minimum)}}
                SAMPLE_TYPE           = {{format.TypeKeyword}}
                SAMPLE_BITS           = {{8 * format.SampleBytes}}
                UNIT                  = {{format.Unit}}
                SCALING_FACTOR        = {{format.ScalingFactor}}
                OFFSET                = {{format.Offset}}
              END_OBJECT              = IMAGE
            END_OBJECT                = UNCOMPRESSED_FILE
            OBJECT                    = IMAGE_MAP_PROJECTION
             ^DATA_SET_MAP_PROJECTION     = "DSMAP_POLAR.CAT"
             MAP_PROJECTION_TYPE          = "POLAR STEREOGRAPHIC"
             MAP_RESOLUTION               = {{resolution:0.0000}} <pix/deg>
             A_AXIS_RADIUS                = 1737.4 <km>
             B_AXIS_RADIUS                = 1737.4 <km>
             C_AXIS_RADIUS                = 1737.4 <km>
             FIRST_STANDARD_PARALLEL      = 'N/A'
             SECOND_STANDARD_PARALLEL     = 'N/A'
             POSITIVE_LONGITUDE_DIRECTION = "EAST"
             CENTER_LATITUDE              = {{pole}} <deg>
             CENTER_LONGITUDE             = 0 <deg>
             REFERENCE_LATITUDE           = 'N/A'
             REFERENCE_LONGITUDE          = 'N/A'
             LINE_FIRST_PIXEL             = 1
             LINE_LAST_PIXEL              = {{options.Side}}
             SAMPLE_FIRST_PIXEL           = 1
             SAMPLE_LAST_PIXEL            = {{options.Side}}
             MAP_PROJECTION_ROTATION      = 0.0
             MAP_SCALE                    = {{options.MetresPerPixel:R}} <m/pix>
             MAXIMUM_LATITUDE             = {{Math.Max(pole, border):R}} <deg>
             MINIMUM_LATITUDE             = {{Math.Min(pole, border):R}} <deg>
             WESTERNMOST_LONGITUDE        = 0 <deg>
             EASTERNMOST_LONGITUDE        = 360 <deg>
             LINE_PROJECTION_OFFSET       = {{options.Projection.LineOffset:0.0}} <pix>
             SAMPLE_PROJECTION_OFFSET     = {{options.Projection.SampleOffset:0.0}} <pix>
             COORDINATE_SYSTEM_TYPE       = "BODY-FIXED ROTATING"
             COORDINATE_SYSTEM_NAME       = "MEAN EARTH/POLAR AXIS OF DE421"
            END_OBJECT                    = IMAGE_MAP_PROJECTION

            END

            """));
    }
}
