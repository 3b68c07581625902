using System.Buffers.Binary;
using System.Text;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>
/// A map of the south pole of 60 x 64 samples and 5000 m a pixel with a label in NASA's form (LDEM_80S_20M.LBL); the pole is beside the
/// middle.
/// </summary>
internal static class PolarTestModel
{
    public const int Lines = 60;
    public const int Samples = 64;

    public const string Label = """
        PDS_VERSION_ID            = "PDS3"
        PRODUCT_ID                = "LDEM_85S_5000M"
        TARGET_NAME               = MOON
        OBJECT                    = UNCOMPRESSED_FILE
        FILE_NAME                 = "LDEM_85S_5000M.IMG"
        RECORD_TYPE               = FIXED_LENGTH
        FILE_RECORDS              = 60
        RECORD_BYTES              = 128
        ^IMAGE                    = "LDEM_85S_5000M.IMG"
          OBJECT                  = IMAGE
            LINES                 = 60
            LINE_SAMPLES          = 64
            MAXIMUM               = 4000
            MINIMUM               = -4000
            SAMPLE_TYPE           = LSB_INTEGER
            SAMPLE_BITS           = 16
            UNIT                  = METER
            SCALING_FACTOR        = 0.5
            OFFSET                = 1737400.
          END_OBJECT              = IMAGE
        END_OBJECT                = UNCOMPRESSED_FILE
        OBJECT                    = IMAGE_MAP_PROJECTION
         ^DATA_SET_MAP_PROJECTION     = "DSMAP_POLAR.CAT"
         MAP_PROJECTION_TYPE          = "POLAR STEREOGRAPHIC"
         MAP_RESOLUTION               = 6.0647 <pix/deg>
         A_AXIS_RADIUS                = 1737.4 <km>
         B_AXIS_RADIUS                = 1737.4 <km>
         C_AXIS_RADIUS                = 1737.4 <km>
         POSITIVE_LONGITUDE_DIRECTION = "EAST"
         CENTER_LATITUDE              = -90 <deg>
         CENTER_LONGITUDE             = 0 <deg>
         LINE_FIRST_PIXEL             = 1
         LINE_LAST_PIXEL              = 60
         SAMPLE_FIRST_PIXEL           = 1
         SAMPLE_LAST_PIXEL            = 64
         MAP_PROJECTION_ROTATION      = 0.0
         MAP_SCALE                    = 5000 <m/pix>
         MAXIMUM_LATITUDE             = -85 <deg>
         MINIMUM_LATITUDE             = -90 <deg>
         WESTERNMOST_LONGITUDE        = 0 <deg>
         EASTERNMOST_LONGITUDE        = 360 <deg>
         LINE_PROJECTION_OFFSET       = 29.5 <pix>
         SAMPLE_PROJECTION_OFFSET     = 30.5 <pix>
         COORDINATE_SYSTEM_TYPE       = "BODY-FIXED ROTATING"
         COORDINATE_SYSTEM_NAME       = "MEAN EARTH/POLAR AXIS OF DE421"
        END_OBJECT                    = IMAGE_MAP_PROJECTION
        END

        """;

    /// <summary>A value for each sample.</summary>
    public static short ValueAt(int line, int sample) => (short)((((line * 7919) + (sample * 104729)) % 8001) - 4000);

    /// <summary>Writes label and image; returns the label's path.</summary>
    public static string Write(string folder, string? label = null)
    {
        byte[] image = new byte[2 * Lines * Samples];
        for (int i = 0; i < Lines * Samples; i++)
        {
            BinaryPrimitives.WriteInt16LittleEndian(image.AsSpan(2 * i), ValueAt(i / Samples, i % Samples));
        }

        string path = Path.Combine(folder, "LDEM_85S_5000M.LBL");
        File.WriteAllText(path, label ?? Label, Encoding.Latin1);
        File.WriteAllBytes(Path.ChangeExtension(path, ".IMG"), image);
        return path;
    }
}
