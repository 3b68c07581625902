using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// The PDS3 label of a synthetic product: keywords in the order of the LOLA archive's labels, with values that say that the model is
/// synthetic.
/// </summary>
internal sealed record SyntheticLabel
{
    /// <summary>PRODUCT_ID, and the name of the image without its ending.</summary>
    public required string ProductId { get; init; }

    /// <summary>What the map is, after the sentences that say that it is synthetic; lines of at most 80 characters.</summary>
    public required string Description { get; init; }

    /// <summary>Lines of the image.</summary>
    public required int Lines { get; init; }

    public required int LineSamples { get; init; }

    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>How samples are stored.</summary>
    public required SyntheticSampleFormat Format { get; init; }

    /// <summary>Comments after the keywords of the image; empty, or ended by LF.</summary>
    public string Notes { get; init; } = string.Empty;

    /// <summary>The map's projection.</summary>
    public required SyntheticLabelMap Map { get; init; }

    /// <summary>Writes the label.</summary>
    /// <param name="writer">Receives the text, lines ended by LF.</param>
    /// <param name="minimum">Minimum sample in the image.</param>
    /// <param name="maximum">Maximum sample in the image.</param>
    public void Write(TextWriter writer, double minimum, double maximum) => writer.Write(Invariant($$"""
        PDS_VERSION_ID            = "PDS3"

        /*** GENERAL DATA DESCRIPTION PARAMETERS ***/
        PRODUCT_VERSION_ID        = "V1.0"
        DATA_SET_ID               = "MSISF-L-{{LdemLabel.SyntheticMark}}-LDEM-V1.0"
        PRODUCT_ID                = "{{ProductId}}"
        INSTRUMENT_HOST_NAME      = "N/A"
        INSTRUMENT_NAME           = "N/A"
        INSTRUMENT_ID             = "N/A"
        MISSION_PHASE_NAME        = "N/A"
        TARGET_NAME               = {{Body.CapitalName}}
        START_TIME                = "N/A"
        STOP_TIME                 = "N/A"
        PRODUCT_CREATION_TIME     = "N/A"
        PRODUCER_ID               = "MSISF"
        PRODUCER_FULL_NAME        = "MSISF, msis ldem synthesize"
        PRODUCER_INSTITUTION_NAME = "N/A"
        DESCRIPTION               = "THIS IS SYNTHETIC DATA. NO PART OF THE DETAIL
           WAS MEASURED; IT IS NOT A PRODUCT OF THE LOLA TEAM, NASA OR THE PDS.
        {{Description}}
        "

        OBJECT                    = UNCOMPRESSED_FILE
        FILE_NAME                 = "{{ProductId}}.IMG"
        RECORD_TYPE               = FIXED_LENGTH
        FILE_RECORDS              = {{Lines}}
        RECORD_BYTES              = {{Format.SampleBytes * LineSamples}}
        ^IMAGE                    = "{{ProductId}}.IMG"


          OBJECT                  = IMAGE
            NAME                  = HEIGHT
            DESCRIPTION           = "Each sample represents height relative to a
              reference radius (OFFSET). The heights are synthetic."
            LINES                 = {{Lines}}
            LINE_SAMPLES          = {{LineSamples}}
            MAXIMUM               = {{Format.TextOf(maximum)}}
            MINIMUM               = {{Format.TextOf(minimum)}}
            SAMPLE_TYPE           = {{Format.TypeKeyword}}
            SAMPLE_BITS           = {{8 * Format.SampleBytes}}
            UNIT                  = {{Format.Unit}}
            SCALING_FACTOR        = {{Format.ScalingFactor}}
            OFFSET                = {{Format.OffsetOf(Body.MeanRadius)}}
        {{Notes}}  END_OBJECT              = IMAGE
        END_OBJECT                = UNCOMPRESSED_FILE
        OBJECT                    = IMAGE_MAP_PROJECTION
         ^DATA_SET_MAP_PROJECTION     = "{{Map.Catalogue}}"
         MAP_PROJECTION_TYPE          = "{{Map.Projection}}"
         MAP_RESOLUTION               = {{Map.Resolution}} <pix/deg>
         A_AXIS_RADIUS                = {{Body.MeanRadius / 1000.0:R}} <km>
         B_AXIS_RADIUS                = {{Body.MeanRadius / 1000.0:R}} <km>
         C_AXIS_RADIUS                = {{Body.MeanRadius / 1000.0:R}} <km>
         FIRST_STANDARD_PARALLEL      = 'N/A'
         SECOND_STANDARD_PARALLEL     = 'N/A'
         POSITIVE_LONGITUDE_DIRECTION = "EAST"
         CENTER_LATITUDE              = {{Map.CentreLatitude}} <deg>
         CENTER_LONGITUDE             = {{Map.CentreLongitude}} <deg>
         REFERENCE_LATITUDE           = 'N/A'
         REFERENCE_LONGITUDE          = 'N/A'
         LINE_FIRST_PIXEL             = 1
         LINE_LAST_PIXEL              = {{Lines}}
         SAMPLE_FIRST_PIXEL           = 1
         SAMPLE_LAST_PIXEL            = {{LineSamples}}
         MAP_PROJECTION_ROTATION      = 0.0
         MAP_SCALE                    = {{Map.Scale}} <m/pix>
         MAXIMUM_LATITUDE             = {{Map.North:R}} <deg>
         MINIMUM_LATITUDE             = {{Map.South:R}} <deg>
         WESTERNMOST_LONGITUDE        = {{Map.West}} <deg>
         EASTERNMOST_LONGITUDE        = {{Map.East}} <deg>
         LINE_PROJECTION_OFFSET       = {{Map.LineOffset:0.0}} <pix>
         SAMPLE_PROJECTION_OFFSET     = {{Map.SampleOffset:0.0}} <pix>
         COORDINATE_SYSTEM_TYPE       = "BODY-FIXED ROTATING"
         COORDINATE_SYSTEM_NAME       = "{{(Body.IsMoon ? "MEAN EARTH/POLAR AXIS OF DE421" : Body.Frame)}}"
        END_OBJECT                    = IMAGE_MAP_PROJECTION

        END

        """));
}

/// <summary>The map projection in the label of a synthetic product; latitudes and longitudes in degrees.</summary>
internal sealed record SyntheticLabelMap
{
    /// <summary>The archive's file that describes the projection.</summary>
    public required string Catalogue { get; init; }

    /// <summary>MAP_PROJECTION_TYPE.</summary>
    public required string Projection { get; init; }

    /// <summary>Samples a degree, as text.</summary>
    public required string Resolution { get; init; }

    /// <summary>m a sample, as text.</summary>
    public required string Scale { get; init; }

    /// <summary>Latitude of the projection's centre.</summary>
    public required int CentreLatitude { get; init; }

    /// <summary>Longitude of the projection's centre.</summary>
    public required int CentreLongitude { get; init; }

    /// <summary>The map's northern border.</summary>
    public required double North { get; init; }

    /// <summary>The map's southern border.</summary>
    public required double South { get; init; }

    /// <summary>The map's western border.</summary>
    public required int West { get; init; }

    /// <summary>The map's eastern border.</summary>
    public required int East { get; init; }

    /// <summary>Lines from the product's first pixel to the projection's centre.</summary>
    public required double LineOffset { get; init; }

    /// <summary>Samples from the product's first pixel to the projection's centre.</summary>
    public required double SampleOffset { get; init; }
}
